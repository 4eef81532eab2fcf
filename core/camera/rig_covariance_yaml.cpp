// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/rig_covariance_yaml.h"

#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "core/base/digits.h"
#include "core/camera/rig_parameters.h"

namespace kambara {
namespace {

// Empty where the node is no list of so many finite numbers.
std::optional<Eigen::VectorXd> numbers_of(const YAML::Node& node, std::size_t count) {
    if (!node.IsDefined() || !node.IsSequence() || node.size() != count) {
        return std::nullopt;
    }
    Eigen::VectorXd values(static_cast<Eigen::Index>(count));
    for (std::size_t i = 0; i < count; ++i) {
        double value = 0.0;
        if (!node[i].IsScalar() || !YAML::convert<double>::decode(node[i], value) ||
            !(std::abs(value) < 1e9)) {
            return std::nullopt;
        }
        values[static_cast<Eigen::Index>(i)] = value;
    }
    return values;
}

bool names_are(const YAML::Node& node, const std::vector<std::string>& names) {
    if (!node.IsDefined() || !node.IsSequence() || node.size() != names.size()) {
        return false;
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!node[i].IsScalar() || node[i].Scalar() != names[i]) {
            return false;
        }
    }
    return true;
}

// Of a correlation, which comes back from a covariance rounded in the last of a double's digits: a
// file that is read and written again is to stay the same.
std::string fourteen_digits(double value) {
    char text[32];
    const auto end =
        std::to_chars(std::begin(text), std::end(text), value, std::chars_format::general, 14);
    return {text, end.ptr};
}

template <class ToText>
void write_list(YAML::Emitter& out, const Eigen::VectorXd& values, const ToText& to_text) {
    out << YAML::Flow << YAML::BeginSeq;
    for (const double value : values) {
        out << to_text(value);
    }
    out << YAML::EndSeq;
}

std::string read_section(const YAML::Node& section, const std::vector<std::string>& names,
                         std::optional<Eigen::MatrixXd>& into) {
    if (!section.IsMap()) {
        return "is no section of its own";
    }
    if (!names_are(section["parameters"], names)) {
        return "is not of the parameters of the file's lenses, in their order";
    }
    const auto sigma = numbers_of(section["sigma"], names.size());
    const YAML::Node rows = section["correlation"];
    if (!sigma || sigma->minCoeff() < 0.0 || !rows.IsDefined() || !rows.IsSequence() ||
        rows.size() != names.size()) {
        return "does not hold a sigma and a row of correlations for each parameter";
    }
    const auto n = static_cast<Eigen::Index>(names.size());
    Eigen::MatrixXd covariance(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto row =
            numbers_of(rows[static_cast<std::size_t>(i)], static_cast<std::size_t>(i) + 1);
        if (!row || std::abs((*row)[i] - 1.0) > 1e-9 || row->cwiseAbs().maxCoeff() > 1.0 + 1e-9) {
            return "has a row of correlations that are none";
        }
        for (Eigen::Index j = 0; j <= i; ++j) {
            covariance(i, j) = covariance(j, i) = (*row)[j] * (*sigma)[i] * (*sigma)[j];
        }
    }
    if (auto fault = covariance_fault(n, covariance); !fault.empty()) {
        return fault;
    }
    into = std::move(covariance);
    return {};
}

void write_section(YAML::Emitter& out, const char* key, const std::vector<std::string>& names,
                   const Eigen::MatrixXd& covariance) {
    const Eigen::VectorXd sigma = covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    out << YAML::Key << key << YAML::Value << YAML::BeginMap;
    out << YAML::Key << "parameters" << YAML::Value << YAML::Flow << names;
    out << YAML::Key << "sigma" << YAML::Value;
    write_list(out, sigma, [](double value) { return digits(value); });
    out << YAML::Key << "correlation" << YAML::Value << YAML::BeginSeq;
    for (Eigen::Index i = 0; i < sigma.size(); ++i) {
        Eigen::VectorXd row = Eigen::VectorXd::Zero(i + 1);
        for (Eigen::Index j = 0; j < i; ++j) {
            const double both = sigma[i] * sigma[j];
            row[j] = both > 0.0 ? covariance(i, j) / both : 0.0;
        }
        row[i] = 1.0;
        write_list(out, row, fourteen_digits);
    }
    out << YAML::EndSeq << YAML::EndMap;
}

}  // namespace

std::string read_covariance(const YAML::Node& section, Rig& rig) {
    const auto names = rig_parameter_names(rig);
    if (names.empty()) {
        return "belongs to a pair of cameras, and there is no right one";
    }
    return read_section(section, names, rig.parameter_covariance);
}

std::string read_lens_covariance(const YAML::Node& section, Rig& rig) {
    if (!rig.pan_tilt) {
        return "belongs to a pan-tilt camera, and there is none";
    }
    return read_section(section, lens_parameter_names(rig.pan_tilt->lens),
                        rig.pan_tilt_lens_covariance);
}

void write_covariances(YAML::Emitter& out, const Rig& rig) {
    if (rig.parameter_covariance) {
        write_section(out, "calibration_covariance", rig_parameter_names(rig),
                      *rig.parameter_covariance);
    }
    if (rig.pan_tilt && rig.pan_tilt_lens_covariance) {
        write_section(out, "pan_tilt_lens_covariance", lens_parameter_names(rig.pan_tilt->lens),
                      *rig.pan_tilt_lens_covariance);
    }
}

}  // namespace kambara
