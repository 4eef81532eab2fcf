// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <optional>

namespace kambara {

/// Whether a slope differs from another one by more than chance, with that covariance of their
/// difference: by the chi squared that one of a thousand exceeds.
bool leans_otherwise(const Eigen::Vector2d& slope, const Eigen::Vector2d& other,
                     const Eigen::Matrix2d& covariance);

/// How a target's plane leans, by the weighted mean of what several pairs of pictures say: a
/// template that is carried across the field is drawn as much too narrow as its slope is off. Each
/// must agree with those before it.
class MeanSlope {
  public:
    static constexpr int enough = 10;

    bool is_settled() const { return count_ >= enough; }
    void add(const Eigen::Vector2d& slope, const Eigen::Matrix2d& covariance);
    /// Empty where noise alone may make a plane that is square to the rig's z axis look so.
    std::optional<Eigen::Vector2d> value() const;

  private:
    Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
    Eigen::Vector2d weighted_ = Eigen::Vector2d::Zero();
    int count_ = 0;
};

}  // namespace kambara
