// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/compare_truth.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "core/base/text_file.h"

namespace kambara::cli {
namespace {

constexpr double farthest_from_template_px = 3.0;

using Row = std::map<std::string, double>;  // by column; without what is no number

std::vector<std::string> cells_of(std::string line) {
    if (!line.empty() && line.back() == '\r') {
        line.pop_back();
    }
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');) {
        cells.push_back(cell);
    }
    return cells;
}

std::vector<Row> rows_of(const std::string& text) {
    std::istringstream stream(text);
    std::string line;
    std::getline(stream, line);
    const auto names = cells_of(line);
    std::vector<Row> rows;
    while (std::getline(stream, line)) {
        const auto cells = cells_of(line);
        Row row;
        for (std::size_t i = 0; i < std::min(names.size(), cells.size()); ++i) {
            double value = 0.0;
            const char* end = cells[i].data() + cells[i].size();
            if (std::from_chars(cells[i].data(), end, value).ptr == end && !cells[i].empty()) {
                row[names[i]] = value;
            }
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::optional<Eigen::Vector2d> pixel_of(const Row& row, const char* x, const char* y) {
    return row.contains(x) && row.contains(y) ? std::optional(Eigen::Vector2d(row.at(x), row.at(y)))
                                              : std::nullopt;
}

std::optional<Sighting> sighting_of(const Row& row) {
    const auto left = pixel_of(row, "left_x_px", "left_y_px");
    if (!left || !row.contains("frame")) {
        return std::nullopt;
    }
    Sighting sighting{*left, pixel_of(row, "right_x_px", "right_y_px"), std::nullopt};
    if (row.contains("x_mm") && row.contains("y_mm") && row.contains("z_mm")) {
        sighting.range_mm = Eigen::Vector3d(row.at("x_mm"), row.at("y_mm"), row.at("z_mm")).norm();
    }
    return sighting;
}

}  // namespace

std::optional<Sighting> sighting_of(const Rig& rig, const Eigen::Vector3d& point_in_left_mm) {
    const Eigen::Vector3d point_in_rig_mm = rig.left.T_camera_from_rig.inverse() * point_in_left_mm;
    const auto left = rig.left.project(point_in_rig_mm);
    if (!left) {
        return std::nullopt;
    }
    return Sighting{*left, rig.right ? rig.right->project(point_in_rig_mm) : std::nullopt,
                    point_in_left_mm.norm()};
}

Result<Done> read_truth(const std::filesystem::path& file, CompareScene& scene) {
    const auto text = read_text_file(file);
    if (!text) {
        return text.error();
    }
    std::map<std::int64_t, Sighting> by_frame;
    for (const Row& row : rows_of(*text)) {
        if (const auto sighting = sighting_of(row)) {
            by_frame[std::llround(row.at("frame"))] = *sighting;
        }
    }
    const auto first = by_frame.find(scene.pairs.front().left.index);
    if (first == by_frame.end()) {
        return Error{"The truth " + file.string() + " says nothing of the first frame.",
                     "Give a table with the columns frame, left_x_px, left_y_px."};
    }
    const Eigen::Vector2d apart_px =
        Eigen::Vector2d(scene.templ.centre_x_px(), scene.templ.centre_y_px()) -
        first->second.left_px;
    if (apart_px.norm() > farthest_from_template_px) {
        char distance[32];
        std::snprintf(distance, sizeof distance, "%.0f", apart_px.norm());
        return Error{"The template's centre is " + std::string(distance) +
                         " px from the point that the truth speaks of.",
                     "Choose the template about that point, or leave --truth out."};
    }
    for (std::size_t i = 0; i < scene.pairs.size(); ++i) {
        const auto known = by_frame.find(scene.pairs[i].left.index);
        if (known == by_frame.end()) {
            continue;
        }
        Sighting sighting = known->second;
        sighting.left_px += apart_px;
        if (sighting.right_px) {
            *sighting.right_px += apart_px;
        }
        scene.truth[i] = sighting;
    }
    return Done{};
}

}  // namespace kambara::cli
