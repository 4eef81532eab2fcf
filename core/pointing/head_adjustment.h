// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "core/camera/rig.h"
#include "core/pointing/head_calibration.h"

namespace kambara {

constexpr int head_numbers = 16;

/// What calibrate_head() looks for: the head's sixteen numbers (base turn 0-2, base place 3-5, arm
/// 6, skew 7, camera turn 8-10, camera place 11-13, backlash 14-15), what the rig and then the
/// pan-tilt camera's lens are off by along the axes of their covariances, in deviations, and by
/// what each view's target is moved.
struct HeadUnknowns {
    HeadModel model;
    Eigen::VectorXd rig_off;
    std::vector<RigidTransform> T_rig_from_placed;  ///< one a view
};

/// Least squares of the pixels of all three cameras and of what is believed of the rig and of the
/// head, by Levenberg and Marquardt; the views' own unknowns are eliminated (Schur's complement).
class HeadAdjustment {
  public:
    /// The rig takes part where it has a covariance and a view has pixels of the fixed cameras; the
    /// pan-tilt camera's lens where that has one, too.
    HeadAdjustment(const Rig& rig, const std::vector<HeadView>& views);

    /// Deviations of the pixels that the squares are weighed by.
    struct Sigmas {
        double head_px = 0.1;
        double pair_px = 0.1;
    };
    /// Of the pixels' errors alone, px^2, with how many pixels there were.
    struct Squares {
        double head_px2 = 0.0;
        double pair_px2 = 0.0;
        int head = 0;
        int pair = 0;
    };
    /// The derivatives' products: those of the head and the rig, and for each view its own.
    struct Equations {
        struct Place {
            Eigen::MatrixXd shared_by_place;
            Eigen::Matrix<double, 6, 6> place;
            Eigen::Matrix<double, 6, 1> place_gradient;
            Eigen::VectorXd shared_gradient;  ///< this view's part
        };
        Eigen::MatrixXd shared;
        Eigen::VectorXd gradient;
        std::vector<Place> places;
        double cost = 0.0;
        Squares squares;
    };

    HeadUnknowns start(const HeadModel& model) const;
    /// Empty where a point projects nowhere.
    std::optional<Equations> equations(const HeadUnknowns& at, const Sigmas& sigmas) const;
    /// From there to the least squares; empty where the start already projects nowhere.
    std::optional<HeadUnknowns> solved(HeadUnknowns at, const Sigmas& sigmas) const;
    /// What the pixels' scatter at a solution says of their deviations, each kind by itself.
    Sigmas sigmas_of(const Squares& squares) const;
    /// Of the head's numbers and the rig's, at a solution: by the pixels' deviations and the rig's,
    /// or by the scatter from view to view where that says more.
    Eigen::MatrixXd covariance(const Equations& at_solution) const;

    bool rig_takes_part() const { return by_rig_axis_.cols() > 0; }
    bool lens_takes_part() const { return by_lens_axis_.cols() > 0; }
    /// By how much the rig's parameters (rig_parameters.h) are more.
    Eigen::VectorXd parameters_off(const HeadUnknowns& at) const;
    /// By how much the pan-tilt camera's lens's are more.
    Eigen::VectorXd lens_off(const HeadUnknowns& at) const;
    /// What is left of their covariances, of that of all shared unknowns.
    Eigen::MatrixXd parameters_left(const Eigen::MatrixXd& covariance) const;
    Eigen::MatrixXd lens_left(const Eigen::MatrixXd& covariance) const;

  private:
    struct Rows;
    bool add_head_pixels(const HeadUnknowns& at, const Lens& lens, std::size_t view,
                         Rows& rows) const;
    bool add_pair_pixels(const HeadUnknowns& at, const Rig& rig, std::size_t view,
                         Rows& rows) const;
    HeadUnknowns stepped(const HeadUnknowns& at, const Equations& equations, double damping) const;

    const Rig& rig_;
    const std::vector<HeadView>& views_;
    // Parameters by one deviation along each axis of their covariance.
    Eigen::MatrixXd by_rig_axis_;
    Eigen::MatrixXd by_lens_axis_;
};

}  // namespace kambara
