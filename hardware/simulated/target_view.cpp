// SPDX-License-Identifier: GPL-3.0-or-later
#include "hardware/simulated/target_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hardware/simulated/blur.h"

namespace kambara {
namespace {

constexpr int samples_across = 4;  // of a pixel, and as many down

struct Box {
    int x0, y0, x1, y1;  // one past the last
};

// The pixels that the sheets can touch and `margin_px` more: their outlines are followed, since a
// lens bends them.
Box box_of(const std::vector<TargetPatch>& sheets, const Camera& camera, double margin_px) {
    constexpr int steps = 8;
    Eigen::Vector2d low(1e9, 1e9);
    Eigen::Vector2d high(-1e9, -1e9);
    for (const TargetPatch& sheet : sheets) {
        for (int i = 0; i <= steps; ++i) {
            for (int j = 0; j <= steps; ++j) {
                if (i % steps != 0 && j % steps != 0) {
                    continue;
                }
                const Eigen::Vector3d point = sheet.origin_mm +
                                              (static_cast<double>(i) / steps) * sheet.across_mm +
                                              (static_cast<double>(j) / steps) * sheet.down_mm;
                if (const auto pixel = kambara::project(camera.lens, point)) {
                    low = low.cwiseMin(*pixel);
                    high = high.cwiseMax(*pixel);
                }
            }
        }
    }
    const auto inside = [](double value, int limit) {
        return static_cast<int>(std::clamp(value, 0.0, static_cast<double>(limit)));
    };
    return {inside(low.x() - 3.0 - margin_px, camera.width_px),
            inside(low.y() - 3.0 - margin_px, camera.height_px),
            inside(high.x() + 4.0 + margin_px, camera.width_px),
            inside(high.y() + 4.0 + margin_px, camera.height_px)};
}

// What the sheets put into a pixel: their mean level where they cover it.
template <class Level>
struct Covered {
    float share = 0.0F;
    Level surface;
    float depth_mm;
};

template <class Level>
class TargetRow {
  public:
    TargetRow(const Scene& scene, const PixelRays& rays, const std::vector<TargetPatch>& patches)
        : scene_(scene), rays_(rays), sheets_(patches.begin(), patches.end()) {}

    // The sheets are met exactly at the pixels' corners only: within a pixel, a place on a sheet
    // is as good as linear.
    void meet(const Box& box, int y) {
        corners_ = static_cast<std::size_t>(std::max(0, box.x1 - box.x0)) + 1;
        meetings_.clear();
        const std::size_t stride = rays_.stride();
        for (const Sheet& sheet : sheets_) {
            for (int corner_y = y; corner_y <= y + 1; ++corner_y) {
                const Eigen::Vector2f* s = rays_.from(box.x0 - 1, corner_y - 1);
                for (std::size_t i = 0; i < corners_; ++i, ++s) {
                    meetings_.push_back(
                        sheet.meet(0.25F * (s[0] + s[1] + s[stride] + s[stride + 1])));
                }
            }
        }
    }

    // Of the pixel so far on in the row that was met.
    Covered<Level> pixel(std::size_t on) const {
        constexpr int n = samples_across * samples_across;
        std::array<float, n> depth;
        std::array<Level, n> surface;
        depth.fill(std::numeric_limits<float>::max());
        for (std::size_t k = 0; k < sheets_.size(); ++k) {
            const Sheet::Meeting* top = meetings_.data() + 2 * k * corners_ + on;
            const Sheet::Meeting* bottom = top + corners_;
            if (std::min({top[0].depth_mm, top[1].depth_mm, bottom[0].depth_mm,
                          bottom[1].depth_mm}) <= 0.0F) {
                continue;
            }
            for (int j = 0; j < n; ++j) {
                const float a = (static_cast<float>(j % samples_across) + 0.5F) / samples_across;
                const float b = (static_cast<float>(j / samples_across) + 0.5F) / samples_across;
                const auto within = [&](float Sheet::Meeting::*part) {
                    return (1 - b) * ((1 - a) * top[0].*part + a * top[1].*part) +
                           b * ((1 - a) * bottom[0].*part + a * bottom[1].*part);
                };
                const float u = within(&Sheet::Meeting::u_mm);
                const float v = within(&Sheet::Meeting::v_mm);
                const float here = within(&Sheet::Meeting::depth_mm);
                const auto i = static_cast<std::size_t>(j);
                if (sheets_[k].covers(u, v) && here < depth[i]) {
                    depth[i] = here;
                    surface[i] = scene_.surface<Level>(k, u, v);
                }
            }
        }
        Level sum = Channels<Level>::flat(0.0F);
        float depth_sum = 0.0F;
        int hits = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (depth[i] < std::numeric_limits<float>::max()) {
                sum += surface[i];
                depth_sum += depth[i];
                ++hits;
            }
        }
        if (hits == 0) {
            return {0.0F, sum, 0.0F};
        }
        const auto count = static_cast<float>(hits);
        return {count / n, sum / count, depth_sum / count};
    }

  private:
    const Scene& scene_;
    const PixelRays& rays_;
    const std::vector<Sheet> sheets_;
    std::size_t corners_ = 0;
    std::vector<Sheet::Meeting> meetings_;  // sheet by sheet, the upper corners, then the lower
};

// Adds a patch of a picture, blurred.
template <class Level>
void add_blurred(std::vector<Level>& picture, int picture_width, std::vector<Level>& patch,
                 const Box& box, double sigma_px) {
    const int width = box.x1 - box.x0;
    blur(patch.data(), width,
         std::vector<double>(static_cast<std::size_t>(box.y1 - box.y0), sigma_px));
    auto from = patch.cbegin();
    for (int y = box.y0; y < box.y1; ++y) {
        Level* row =
            picture.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(picture_width);
        for (int x = box.x0; x < box.x1; ++x) {
            row[x] += *from++;
        }
    }
}

}  // namespace

template <class Level>
void draw_target(std::vector<Level>& picture, const SeabedView<Level>& seabed, const Scene& scene,
                 const Camera& camera, const PixelRays& rays, const Lighting<Level>& lighting,
                 const std::vector<TargetPatch>& sheets_in_camera, double blur_px) {
    const bool forward = lighting.scatters_forward();
    const Box box = box_of(sheets_in_camera, camera, forward ? std::ceil(3.0 * blur_px) : 0.0);
    if (box.x0 >= box.x1 || box.y0 >= box.y1) {
        return;
    }
    // The target's scattered light takes the place of what the seabed there would scatter.
    std::vector<Level> scattered;
    TargetRow<Level> target(scene, rays, sheets_in_camera);
    for (int y = box.y0; y < box.y1; ++y) {
        const std::size_t first =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width_px);
        Level* row = picture.data() + first;
        const Level* behind = forward ? seabed.sharp.data() + first : row;
        target.meet(box, y);
        for (int x = box.x0; x < box.x1; ++x) {
            const auto covered = target.pixel(static_cast<std::size_t>(x - box.x0));
            Level change = Channels<Level>::flat(0.0F);
            if (covered.share > 0.0F) {
                const float length = std::sqrt(1.0F + rays.from(x, y)->squaredNorm());
                const double range_mm = static_cast<double>(covered.depth_mm * length);
                const Level seen = lighting.seen(covered.surface, x, y, range_mm);
                row[x] += covered.share * (seen - behind[x]);
                if (forward) {
                    change =
                        covered.share * (lighting.scattered(covered.surface, x, y, range_mm) -
                                         seabed.scattered[first + static_cast<std::size_t>(x)]);
                }
            }
            if (forward) {
                scattered.push_back(change);
            }
        }
    }
    if (forward) {
        add_blurred(picture, camera.width_px, scattered, box, std::max(1e-3, blur_px));
    }
}

template void draw_target(std::vector<float>&, const SeabedView<float>&, const Scene&,
                          const Camera&, const PixelRays&, const Lighting<float>&,
                          const std::vector<TargetPatch>&, double);
template void draw_target(std::vector<Colour>&, const SeabedView<Colour>&, const Scene&,
                          const Camera&, const PixelRays&, const Lighting<Colour>&,
                          const std::vector<TargetPatch>&, double);

}  // namespace kambara
