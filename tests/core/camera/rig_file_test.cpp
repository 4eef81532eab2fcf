// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/camera/rig_file.h"

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "core/camera/nominal_rig.h"
#include "core/camera/rig_parameters.h"

namespace kambara {
namespace {

Rig rig_with_both_lens_kinds() {
    Rig rig = nominal_rig(Medium::water);
    rig.right->lens =
        BrownLens(503.1, 1.0 / 3.0 + 500, 321.7, 238.9, {-0.3, 0.1, 1e-3, -2e-4, 1.0 / 7.0});
    rig.pan_tilt->lens =
        BrownLens(800, 801, 322, 241, {0.1, 0.01, 1e-3, -2e-4, 0.001, 0.2, 0.02, 0.003});
    rig.provenance = {"chessboard:9x6:30, \"brown\", 14 views",
                      "2026-01-02T03:04:05Z",
                      "test 1",
                      0.125,
                      std::nullopt,
                      "model brown, medium water",
                      {"left \"00\".png 0011223344556677", "right00.png 8899aabbccddeeff"}};
    return rig;
}

void expect_same_camera(const Camera& a, const Camera& b) {
    EXPECT_EQ(a.lens, b.lens);
    EXPECT_EQ(a.width_px, b.width_px);
    EXPECT_EQ(a.height_px, b.height_px);
    EXPECT_LE((a.T_camera_from_rig.R - b.T_camera_from_rig.R).norm(), 1e-12);
    EXPECT_LE((a.T_camera_from_rig.t_mm - b.T_camera_from_rig.t_mm).norm(), 1e-12);
}

// The node that a dotted path such as cameras.left.lens leads to.
YAML::Node node_at(YAML::Node node, const std::string& path) {
    std::istringstream parts(path);
    for (std::string key; std::getline(parts, key, '.');) {
        node.reset(node[key]);
    }
    return node;
}

std::string without(const std::string& path) {
    YAML::Node root = YAML::Load(rig_to_text(nominal_rig()));
    const auto dot = path.rfind('.');
    YAML::Node parent = dot == std::string::npos ? root : node_at(root, path.substr(0, dot));
    EXPECT_TRUE(parent.remove(dot == std::string::npos ? path : path.substr(dot + 1))) << path;
    return YAML::Dump(root);
}

std::string with(const Rig& rig, const std::string& path, const std::string& value) {
    YAML::Node root = YAML::Load(rig_to_text(rig));
    node_at(root, path) = YAML::Load(value);
    return YAML::Dump(root);
}

TEST(RigFile, ReadsWhatItWrites) {
    const Rig rig = rig_with_both_lens_kinds();
    const auto read = rig_from_text(rig_to_text(rig));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->medium, Medium::water);
    expect_same_camera(read->left, rig.left);
    expect_same_camera(*read->right, *rig.right);
    expect_same_camera(*read->pan_tilt, *rig.pan_tilt);
    EXPECT_EQ(read->provenance.method, rig.provenance.method);
    EXPECT_EQ(read->provenance.created, rig.provenance.created);
    EXPECT_EQ(read->provenance.stereo_rms_px, 0.125);
    EXPECT_EQ(read->provenance.baseline_sigma_mm, std::nullopt);
    EXPECT_EQ(read->provenance.settings, rig.provenance.settings);
    EXPECT_EQ(read->provenance.pictures, rig.provenance.pictures);
}

TEST(RigFile, OneCameraIsARigToo) {
    Rig rig = nominal_rig();
    rig.right.reset();
    rig.pan_tilt.reset();
    const auto read = rig_from_text(rig_to_text(rig));
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_FALSE(read->right);
    EXPECT_FALSE(read->pan_tilt);
}

TEST(RigFile, NamesTheKeyThatIsMissing) {
    for (const std::string path : {"kambara_rig",
                                   "units",
                                   "units.length",
                                   "medium",
                                   "cameras",
                                   "cameras.left",
                                   "cameras.left.size_px",
                                   "cameras.left.lens",
                                   "cameras.left.lens.model",
                                   "cameras.left.lens.f_mm",
                                   "cameras.left.lens.kappa1_per_mm2",
                                   "cameras.left.lens.cx_px",
                                   "cameras.left.lens.cy_px",
                                   "cameras.left.lens.sx",
                                   "cameras.left.lens.sensor",
                                   "cameras.left.lens.sensor.dx_mm",
                                   "cameras.left.lens.sensor.dy_mm",
                                   "cameras.left.lens.sensor.ncx",
                                   "cameras.left.lens.sensor.nfx",
                                   "cameras.left.T_camera_from_rig",
                                   "cameras.left.T_camera_from_rig.R",
                                   "cameras.right.T_camera_from_rig.t_mm",
                                   "cameras.pan_tilt.lens.sx"}) {
        const auto read = rig_from_text(without(path));
        ASSERT_FALSE(read) << path;
        EXPECT_NE(read.error().cause.find(" " + path + " "), std::string::npos)
            << path << ": " << read.error().cause;
    }
}

TEST(RigFile, NamesTheKeyWhoseValueCannotBe) {
    struct Case {
        const char* path;
        const char* value;
    };
    for (const auto& [path, value] : {
             Case{"kambara_rig", "2"},
             {"units.length", "m"},
             {"medium", "mud"},
             {"cameras.left.lens.model", "pinhole"},
             {"cameras.left.lens.f_mm", "0"},
             {"cameras.left.lens.f_mm", "-2.8"},
             {"cameras.left.lens.f_mm", ".nan"},
             {"cameras.left.lens.f_mm", "1e300"},
             {"cameras.left.lens.f_mm", "wide"},
             {"cameras.left.lens.f_mm", "[2.8]"},
             {"cameras.left.lens.sx", "10"},
             {"cameras.left.lens.sensor.dx_mm", ".inf"},
             {"cameras.left.lens.sensor", "{dx_mm: -0.006, dy_mm: 0.007, ncx: 768, nfx: 640}"},
             {"cameras.left.size_px", "-1"},
             {"cameras.left.size_px", "[-1, 480]"},
             {"cameras.left.size_px", "[640.5, 480]"},
             {"cameras.left.size_px", "[640, 480, 3]"},
             {"cameras.left.T_camera_from_rig.R", "[[1, 0, 0], [0, 1, 0], [0, 0, 1.01]]"},
             {"cameras.left.T_camera_from_rig.R", "[[1, 0, 0], [0, 1, 0], [0, 0, -1]]"},
             {"cameras.left.T_camera_from_rig.R", "[[1, 0, 0], [0, 1, 0]]"},
             {"cameras.left.T_camera_from_rig.t_mm", "[0, 0]"},
         }) {
        const auto read = rig_from_text(with(nominal_rig(), path, value));
        ASSERT_FALSE(read) << path << " = " << value;
        EXPECT_NE(read.error().cause.find(path), std::string::npos)
            << path << " = " << value << ": " << read.error().cause;
        EXPECT_FALSE(read.error().remedy.empty());
    }
}

TEST(RigFile, RefusesCamerasThatCannotBe) {
    const auto cause_of = [](const std::string& text) {
        const auto read = rig_from_text(text);
        return read ? std::string("accepted") : read.error().cause;
    };
    EXPECT_NE(cause_of(with(nominal_rig(), "cameras.right.T_camera_from_rig.t_mm", "[0, 0, 0]"))
                  .find("same place"),
              std::string::npos);
    EXPECT_NE(cause_of(with(nominal_rig(), "cameras.left.lens.f_mm", "0.001")).find("focal length"),
              std::string::npos);
    EXPECT_NE(cause_of(with(nominal_rig(), "cameras.left.lens.kappa1_per_mm2", "-9"))
                  .find("distortion is so strong"),
              std::string::npos);
    EXPECT_NE(cause_of(with(rig_with_both_lens_kinds(), "cameras.right.lens.distortion", "[1, 2]"))
                  .find("5 or 8 terms"),
              std::string::npos);
    EXPECT_NE(cause_of(with(rig_with_both_lens_kinds(), "cameras.right.lens.fx_px", "0"))
                  .find("cameras.right.lens.fx_px"),
              std::string::npos);
}

TEST(RigFile, AnyBytesAreSafeToPass) {
    const std::string whole = rig_to_text(rig_with_both_lens_kinds());
    int refused = 0;
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        refused += rig_from_text(whole.substr(0, size)).ok() ? 0 : 1;
    }
    EXPECT_GT(refused, 100);
    for (const std::string& text :
         {std::string("\0\xff\xfe", 3), std::string(100000, '['), std::string("&a [*a, *a]"),
          std::string("kambara_rig: &a {x: *a}"), std::string("cameras: 3\nkambara_rig: 1"),
          std::string("- 1\n- 2"), std::string("kambara_rig: 1\nunits: [mm]\nmedium: air")}) {
        EXPECT_FALSE(rig_from_text(text));
    }
}

// A covariance of the nominal rig's parameters with one of them held.
Rig rig_with_covariance() {
    Rig rig = nominal_rig();
    const auto n = static_cast<Eigen::Index>(rig_parameter_names(rig).size());
    Eigen::MatrixXd half = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j <= i; ++j) {
            half(i, j) = 1e-3 * std::sin(1.0 + static_cast<double>(7 * i + 3 * j));
        }
    }
    half.row(3).setZero();
    rig.parameter_covariance = half * half.transpose();
    return rig;
}

TEST(RigFile, KeepsTheCalibrationsCovariance) {
    const Rig rig = rig_with_covariance();
    const auto again = rig_from_text(rig_to_text(rig));
    ASSERT_TRUE(again) << again.error().text();
    ASSERT_TRUE(again->parameter_covariance);
    const Eigen::MatrixXd& a = *rig.parameter_covariance;
    EXPECT_LE((a - *again->parameter_covariance).cwiseAbs().maxCoeff(), 1e-13 * a.norm());
    EXPECT_EQ(rig_to_text(*again), rig_to_text(rig));
    EXPECT_EQ(again->parameter_covariance->row(3).norm(), 0.0);
    EXPECT_FALSE(rig_from_text(rig_to_text(nominal_rig()))->parameter_covariance);
}

TEST(RigFile, KeepsTheCovarianceOfThePanTiltLens) {
    Rig rig = nominal_rig();
    Eigen::MatrixXd covariance = Eigen::VectorXd::LinSpaced(5, 0.1, 0.5).asDiagonal();
    covariance(0, 1) = covariance(1, 0) = 0.04;
    rig.pan_tilt_lens_covariance = covariance;
    const std::string text = rig_to_text(rig);
    const auto again = rig_from_text(text);
    ASSERT_TRUE(again) << again.error().text();
    ASSERT_TRUE(again->pan_tilt_lens_covariance);
    EXPECT_LT((covariance - *again->pan_tilt_lens_covariance).norm(), 1e-12);
    EXPECT_FALSE(again->parameter_covariance);
    EXPECT_EQ(rig_to_text(*again), text);
    YAML::Node root = YAML::Load(text);
    root["pan_tilt_lens_covariance"]["sigma"][2] = "-1";
    EXPECT_FALSE(rig_from_text(YAML::Dump(root)));
    root = YAML::Load(text);
    root["cameras"].remove("pan_tilt");
    const auto none = rig_from_text(YAML::Dump(root));
    ASSERT_FALSE(none);
    EXPECT_NE(none.error().cause.find("pan_tilt_lens_covariance"), std::string::npos);
}

TEST(RigFile, RefusesACovarianceThatIsNone) {
    const Rig rig = rig_with_covariance();
    const std::string section = "calibration_covariance";
    const auto refused = [&](const std::string& path, const std::string& value) {
        const auto read = rig_from_text(with(rig, section + path, value));
        EXPECT_FALSE(read) << path << " " << value;
        return !read && read.error().cause.find(section) != std::string::npos;
    };
    EXPECT_TRUE(refused("", "7"));
    EXPECT_TRUE(refused(".sigma", "[1, 2]"));
    EXPECT_TRUE(refused(".parameters", "[left.f_mm]"));
    EXPECT_TRUE(refused(".correlation", "[[1], [0.5, 1]]"));
    YAML::Node root = YAML::Load(rig_to_text(rig));
    root[section]["sigma"][2] = "-1";
    EXPECT_FALSE(rig_from_text(YAML::Dump(root)));
    root = YAML::Load(rig_to_text(rig));
    root[section]["correlation"][5][0] = ".nan";
    EXPECT_FALSE(rig_from_text(YAML::Dump(root)));
    // Three that can't go together: a with b, b with c, a against c.
    root = YAML::Load(rig_to_text(rig));
    root[section]["correlation"][1][0] = "1";
    root[section]["correlation"][2][1] = "1";
    root[section]["correlation"][2][0] = "-1";
    EXPECT_FALSE(rig_from_text(YAML::Dump(root)));
    // It belongs to a pair.
    root = YAML::Load(rig_to_text(rig));
    root["cameras"].remove("right");
    EXPECT_FALSE(rig_from_text(YAML::Dump(root)));
}

}  // namespace
}  // namespace kambara
