// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/detect_stages.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/calibration/sliding_mean.h"
#include "core/image/opencv_view.h"
#include "hardware/media/picture_file.h"

namespace kambara::cli {
namespace {

namespace fs = std::filesystem;

const cv::Scalar red(60, 60, 255);
const cv::Scalar green(80, 220, 80);
const cv::Scalar blue(255, 140, 60);
const cv::Scalar yellow(60, 230, 255);
constexpr int smallest_width = 1000;  // small pictures are drawn larger
constexpr int fraction_bits = 4;      // OpenCV draws at sixteenths of a pixel

// The picture in colour, enlarged by a whole number, to draw on in its own pixels.
class Canvas {
  public:
    explicit Canvas(const Image& grey) {
        scale_ = std::max(1, (smallest_width + grey.width() - 1) / std::max(1, grey.width()));
        cv::Mat colour;
        cv::cvtColor(opencv_view(grey), colour, cv::COLOR_GRAY2BGR);
        cv::resize(colour, drawn_, {}, scale_, scale_, cv::INTER_NEAREST);
    }
    void line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const cv::Scalar& colour) {
        cv::line(drawn_, at(a), at(b), colour, 1, cv::LINE_AA, fraction_bits);
    }
    void ring(const Eigen::Vector2d& centre, double radius, const cv::Scalar& colour) {
        cv::circle(drawn_, at(centre), static_cast<int>(std::lround(radius * scale_ * 16.0)),
                   colour, 1, cv::LINE_AA, fraction_bits);
    }
    void dot(const Eigen::Vector2d& place, const cv::Scalar& colour) {
        cv::circle(drawn_, at(place), 24, colour, cv::FILLED, cv::LINE_AA, fraction_bits);
    }
    void text(const Eigen::Vector2d& place, const std::string& words, const cv::Scalar& colour) {
        const cv::Point p = at(place);
        cv::putText(drawn_, words, {p.x / 16 + 3, p.y / 16 - 3}, cv::FONT_HERSHEY_SIMPLEX, 0.32,
                    colour, 1, cv::LINE_AA);
    }
    void outline(const Quadrilateral& box, const cv::Scalar& colour) {
        for (std::size_t i = 0; i < 4; ++i) {
            line(box[i], box[(i + 1) % 4], colour);
        }
    }
    Result<Done> write(const fs::path& file) const {
        return write_picture(file, image_from_opencv(drawn_));
    }

  private:
    cv::Point at(const Eigen::Vector2d& place) const {
        const auto enlarged = [&](double v) {
            return static_cast<int>(std::lround(((v + 0.5) * scale_ - 0.5) * 16.0));
        };
        return {enlarged(place.x()), enlarged(place.y())};
    }

    cv::Mat drawn_;
    int scale_ = 1;
};

Result<Done> made(const fs::path& folder) {
    std::error_code code;
    fs::create_directories(folder, code);
    if (code) {
        return Error{"The folder " + folder.string() + " can't be made: " + code.message() + ".",
                     "Give one that can be written to with --stages."};
    }
    return Done{};
}

Canvas edges(const Image& grey, const BoxStages& stages) {
    Canvas canvas(grey);
    for (const EdgeChain& chain : stages.chains) {
        for (const Eigen::Vector2i& p : chain) {
            canvas.dot(p.cast<double>(), green);
        }
    }
    return canvas;
}

Canvas chains(const Image& grey, const BoxStages& stages) {
    Canvas canvas(grey);
    for (const EdgeChain& chain : stages.chains) {
        for (std::size_t i = 0; i < chain.size(); ++i) {
            canvas.line(chain[i].cast<double>(), chain[(i + 1) % chain.size()].cast<double>(), red);
        }
    }
    for (const Quadrilateral& outline : stages.outlines) {
        canvas.outline(outline, yellow);
    }
    return canvas;
}

std::vector<Eigen::Vector2d> centroids_of(const BoxStages& stages) {
    std::vector<Eigen::Vector2d> centroids;
    for (const EdgeChain& chain : stages.chains) {
        centroids.push_back(centroid_of(chain));
    }
    return centroids;
}

Canvas centroids(const Image& grey, const BoxStages& stages) {
    Canvas canvas(grey);
    for (const Eigen::Vector2d& p : centroids_of(stages)) {
        canvas.ring(p, 2.0, red);
    }
    return canvas;
}

Canvas sliding(const Image& grey, const BoxStages& stages, int boxes) {
    Canvas canvas(grey);
    const auto all = centroids_of(stages);
    const SlidingMean result = sliding_mean(all, static_cast<std::size_t>(boxes));
    for (const Eigen::Vector2d& p : all) {
        canvas.ring(p, 2.0, red);
    }
    for (const std::size_t i : result.kept) {
        canvas.dot(all[i], yellow);
    }
    for (std::size_t i = 1; i < result.path.size(); ++i) {
        canvas.line(result.path[i - 1], result.path[i], green);
    }
    if (!result.path.empty()) {
        canvas.ring(result.path.back(), result.forbidden_radius_px, blue);
    }
    return canvas;
}

Canvas lines(const Image& grey, const BoxStages& stages) {
    Canvas canvas(grey);
    for (const FittedBox& box : stages.candidates) {
        canvas.outline(box.corners_px, blue);
        for (const FittedSide& side : box.sides) {
            for (const Eigen::Vector2d& p : side.points_px) {
                canvas.dot(p, yellow);
            }
        }
    }
    return canvas;
}

Canvas corners(const Image& grey, const BoxStages& stages) {
    Canvas canvas(grey);
    for (std::size_t i = 0; i < stages.boxes.size(); ++i) {
        canvas.outline(stages.boxes[i].corners_px, green);
        for (std::size_t k = 0; k < 4; ++k) {
            canvas.ring(stages.boxes[i].corners_px[k], 1.0, red);
        }
        canvas.text(stages.boxes[i].corners_px[3], std::to_string(stages.numbers[i]), yellow);
    }
    return canvas;
}

}  // namespace

Result<Done> write_box_stages(const fs::path& folder, const Image& grey, const BoxStages& stages,
                              int boxes) {
    if (auto done = made(folder); !done) {
        return done;
    }
    const std::pair<const char*, Canvas> all[] = {
        {"1-edges.png", edges(grey, stages)},
        {"2-chains.png", chains(grey, stages)},
        {"3-centroids.png", centroids(grey, stages)},
        {"4-sliding-mean.png", sliding(grey, stages, boxes)},
        {"5-lines.png", lines(grey, stages)},
        {"6-corners.png", corners(grey, stages)},
    };
    for (const auto& [name, canvas] : all) {
        if (auto done = canvas.write(folder / name); !done) {
            return done;
        }
    }
    return Done{};
}

Result<Done> write_order(const fs::path& folder, const Image& grey,
                         const DetectedCorners& corners) {
    if (auto done = made(folder); !done) {
        return done;
    }
    Canvas canvas(grey);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (i > 0) {
            canvas.line(corners[i - 1].px, corners[i].px, blue);
        }
        canvas.dot(corners[i].px, red);
        canvas.text(corners[i].px, std::to_string(corners[i].id), yellow);
    }
    return canvas.write(folder / "7-order.png");
}

}  // namespace kambara::cli
