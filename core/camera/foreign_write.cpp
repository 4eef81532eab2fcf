// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "core/camera/foreign_formats.h"

namespace kambara {
namespace {

constexpr double negligible_px = 1e-3;  // no calibration is as sure

// Both lenses in the other side's terms.
struct Pair {
    BrownLens left;
    BrownLens right;
    double worst_residual_px = 0.0;
};

// A Brown lens with no more terms than allowed goes over as it is. Any other is fitted, with few
// terms where nothing is lost by it: those are easier on who reads them.
Result<FittedLens> in_terms(const Camera& camera, int terms) {
    if (const auto* brown = std::get_if<BrownLens>(&camera.lens)) {
        const auto& p = brown->parameters();
        const bool fits =
            std::all_of(p.begin() + 4 + terms, p.end(), [](double k) { return k == 0.0; });
        if (fits) {
            return FittedLens{*brown, 0.0};
        }
    }
    auto few = fitted_brown(camera, std::min(terms, 5));
    if (terms <= 5 || (few && few->worst_residual_px <= negligible_px)) {
        return few;
    }
    const auto all = fitted_brown(camera, terms);
    return few && (!all || few->worst_residual_px < all->worst_residual_px) ? few : all;
}

Result<Pair> pair_in_terms(const Rig& rig, int terms, const char* program) {
    if (!rig.right) {
        return Error{"The rig file holds no right camera.",
                     "Only pairs of cameras can be converted."};
    }
    const auto left = in_terms(rig.left, terms);
    const auto right = in_terms(*rig.right, terms);
    if (!left || !right) {
        return left ? right.error() : left.error();
    }
    const double worst_px = std::max(left->worst_residual_px, right->worst_residual_px);
    if (worst_px > most_export_residual_px) {
        return Error{std::string("The lenses do not fit into ") + program + "'s model: " +
                         std::to_string(worst_px) + " px remain at the worst place, " +
                         std::to_string(most_export_residual_px) + " are allowed.",
                     "Convert to a format with more distortion terms, such as opencv."};
    }
    return Pair{left->lens, right->lens, worst_px};
}

std::string digits(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", value);
    // A whole number must still read as a floating-point one.
    const std::string result = text;
    return result.find_first_of(".en") == std::string::npos ? result + ".0" : result;
}

std::string list(const std::vector<double>& values) {
    std::string text = "[ ";
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += (i > 0 ? ", " : "") + digits(values[i]);
    }
    return text + " ]";
}

std::vector<double> matrix_of(const BrownLens& lens) {
    return {lens.fx_px(), 0.0, lens.cx_px(), 0.0, lens.fy_px(), lens.cy_px(), 0.0, 0.0, 1.0};
}

std::vector<double> rows_of(const Eigen::MatrixXd& M) {
    std::vector<double> values;
    for (Eigen::Index i = 0; i < M.rows(); ++i) {
        for (Eigen::Index j = 0; j < M.cols(); ++j) {
            values.push_back(M(i, j));
        }
    }
    return values;
}

std::string opencv_matrix(const char* name, int rows, int cols, const std::vector<double>& values) {
    return std::string(name) + ": !!opencv-matrix\n   rows: " + std::to_string(rows) +
           "\n   cols: " + std::to_string(cols) + "\n   dt: d\n   data: " + list(values) + "\n";
}

std::string ros_matrix(const char* name, int rows, int cols, const std::vector<double>& values) {
    return std::string(name) + ":\n  rows: " + std::to_string(rows) +
           "\n  cols: " + std::to_string(cols) + "\n  data: " + list(values) + "\n";
}

std::string ros_camera(const char* name, const Camera& camera, const BrownLens& lens,
                       const Eigen::Matrix3d& R_rectified_from_camera, double f_px, double cx_px,
                       double cy_px, double offset_m) {
    const auto D = lens.distortion();
    return "image_width: " + std::to_string(camera.width_px) +
           "\nimage_height: " + std::to_string(camera.height_px) + "\ncamera_name: " + name + "\n" +
           ros_matrix("camera_matrix", 3, 3, matrix_of(lens)) +
           "distortion_model: " + (D.size() > 5 ? "rational_polynomial" : "plumb_bob") + "\n" +
           ros_matrix("distortion_coefficients", 1, static_cast<int>(D.size()), D) +
           ros_matrix("rectification_matrix", 3, 3, rows_of(R_rectified_from_camera)) +
           ros_matrix(
               "projection_matrix", 3, 4,
               {f_px, 0.0, cx_px, f_px * offset_m, 0.0, f_px, cy_px, 0.0, 0.0, 0.0, 1.0, 0.0});
}

std::string kalibr_camera(const char* name, const Camera& camera, const BrownLens& lens) {
    const auto D = lens.distortion();
    return std::string(name) + ":\n  camera_model: pinhole\n  intrinsics: " +
           list({lens.fx_px(), lens.fy_px(), lens.cx_px(), lens.cy_px()}) +
           "\n  distortion_model: radtan\n  distortion_coeffs: " +
           list({D.begin(), D.begin() + 4}) + "\n  resolution: [ " +
           std::to_string(camera.width_px) + ", " + std::to_string(camera.height_px) + " ]\n";
}

}  // namespace

Result<ExportedPair> rig_to_opencv(const Rig& rig) {
    const auto pair = pair_in_terms(rig, 8, "opencv");
    if (!pair) {
        return pair.error();
    }
    const RigidTransform T = T_right_from_left(rig);
    const auto terms = [](const BrownLens& lens) {
        return static_cast<int>(lens.distortion().size());
    };
    ExportedPair files;
    files.worst_residual_px = pair->worst_residual_px;
    files.first = "%YAML:1.0\n---\nimage_width: " + std::to_string(rig.left.width_px) +
                  "\nimage_height: " + std::to_string(rig.left.height_px) + "\n" +
                  opencv_matrix("M1", 3, 3, matrix_of(pair->left)) +
                  opencv_matrix("D1", 1, terms(pair->left), pair->left.distortion()) +
                  opencv_matrix("M2", 3, 3, matrix_of(pair->right)) +
                  opencv_matrix("D2", 1, terms(pair->right), pair->right.distortion());
    files.second = "%YAML:1.0\n---\n" + opencv_matrix("R", 3, 3, rows_of(T.R)) +
                   opencv_matrix("T", 3, 1, {T.t_mm.x(), T.t_mm.y(), T.t_mm.z()});
    return files;
}

Result<ExportedPair> rig_to_ros(const Rig& rig) {
    const auto pair = pair_in_terms(rig, 8, "ros");
    if (!pair) {
        return pair.error();
    }
    // The rig's own axes rectify: x runs along the baseline, z is the mean of the optical axes.
    const double baseline_m = baseline_mm(rig) * 1e-3;
    const double f_px = 0.5 * (pair->left.fy_px() + pair->right.fy_px());
    const double cx_px = 0.5 * (pair->left.cx_px() + pair->right.cx_px());
    const double cy_px = 0.5 * (pair->left.cy_px() + pair->right.cy_px());
    // A rig's x axis may point from right to left only in a rig that was written by hand.
    const Rig straight = rig_from_pair(rig.left, *rig.right, T_right_from_left(rig));
    ExportedPair files;
    files.worst_residual_px = pair->worst_residual_px;
    files.first =
        ros_camera("left", rig.left, pair->left, straight.left.T_camera_from_rig.R.transpose(),
                   f_px, cx_px, cy_px, 0.0);
    files.second = ros_camera("right", *rig.right, pair->right,
                              straight.right->T_camera_from_rig.R.transpose(), f_px, cx_px, cy_px,
                              -baseline_m);
    return files;
}

Result<ExportedPair> rig_to_kalibr(const Rig& rig) {
    const auto pair = pair_in_terms(rig, 4, "kalibr");
    if (!pair) {
        return pair.error();
    }
    const RigidTransform T = T_right_from_left(rig);
    std::string pose = "  T_cn_cnm1:\n";
    for (int i = 0; i < 3; ++i) {
        pose += "    - " + list({T.R(i, 0), T.R(i, 1), T.R(i, 2), T.t_mm[i] * 1e-3}) + "\n";
    }
    pose += "    - " + list({0.0, 0.0, 0.0, 1.0}) + "\n";
    ExportedPair files;
    files.worst_residual_px = pair->worst_residual_px;
    files.first = kalibr_camera("cam0", rig.left, pair->left) +
                  kalibr_camera("cam1", *rig.right, pair->right) + pose;
    return files;
}

}  // namespace kambara
