// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tracking/appearance_bank.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>

namespace kambara {
namespace {

constexpr std::size_t mean_look = 1;
constexpr int border_px = 8;  // for the transforms' and the interpolation's neighbourhoods

}  // namespace

AppearanceBank::AppearanceBank(ReferencePatch first, std::size_t most) : most_(most) {
    patches_.push_back(std::move(first));
    last_use_.push_back(0);
}

std::vector<std::size_t> AppearanceBank::later_by_use() const {
    std::vector<std::size_t> order(patches_.size() - 1);
    std::iota(order.begin(), order.end(), 1);
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return last_use_[a] > last_use_[b]; });
    return order;
}

void AppearanceBank::used(std::size_t i) {
    last_use_[i] = ++uses_;
}

void AppearanceBank::add(ReferencePatch patch) {
    if (patches_.size() >= most_ && patches_.size() > anchors()) {
        const auto oldest = std::min_element(
            last_use_.begin() + static_cast<std::ptrdiff_t>(anchors()), last_use_.end());
        patches_.erase(patches_.begin() + (oldest - last_use_.begin()));
        last_use_.erase(oldest);
    }
    patches_.push_back(std::move(patch));
    last_use_.push_back(++uses_);
}

void AppearanceBank::change(const PlanarChange& by) {
    for (ReferencePatch& patch : patches_) {
        patch.change = patch.change.then(by);
    }
}

void AppearanceBank::lean(const Eigen::Vector2d& slope) {
    for (std::size_t anchor = 0; anchor < anchors(); ++anchor) {
        patches_[anchor].slope = slope;
    }
}

void AppearanceBank::blend(const Camera& left, const Image& grey,
                           const Eigen::Vector3d& point_in_rig_mm, double share) {
    if (mean_.empty()) {
        start_mean();
    }
    const auto seen = drawn_back(first(), left, grey, point_in_rig_mm, mean_piece_);
    if (!seen) {
        return;
    }
    auto picture = std::make_shared<Image>(mean_piece_.width, mean_piece_.height);
    for (std::size_t i = 0; i < mean_.size(); ++i) {
        const float now = seen->row(0)[i];
        mean_[i] += static_cast<float>(share) * (now - mean_[i]);
        picture->row(0)[i] = static_cast<std::uint8_t>(std::lround(mean_[i]));
    }
    ReferencePatch& mean = patches_[mean_look];
    mean.left_grey = std::move(picture);
    mean.piece_at_px = {mean_piece_.x, mean_piece_.y};
}

// It begins as the first template.
void AppearanceBank::start_mean() {
    const ReferencePatch& from = first();
    const Eigen::Vector2i half = from.size_px / 2 + Eigen::Vector2i(border_px, border_px);
    const Eigen::Vector2i middle = from.centre_px.array().round().cast<int>();
    const Image& picture = *from.left_grey;
    const int left = std::max(0, middle.x() - half.x());
    const int top = std::max(0, middle.y() - half.y());
    const int right = std::min(picture.width() - 1, middle.x() + half.x());
    const int bottom = std::min(picture.height() - 1, middle.y() + half.y());
    mean_piece_ = {left, top, right - left + 1, bottom - top + 1};
    for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
            mean_.push_back(picture.at(x, y));
        }
    }
    patches_.insert(patches_.begin() + mean_look, from);
    last_use_.insert(last_use_.begin() + mean_look, ++uses_);
}

}  // namespace kambara
