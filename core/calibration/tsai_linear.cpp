// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/calibration/tsai_linear.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/calibration/point_layout.h"

namespace kambara {
namespace {

// The pixel on the sensor, distorted, from the centre, mm, before s_x.
Eigen::Vector2d on_sensor_mm(const SeenPoint& point, const TsaiLens& given) {
    return {(point.seen_px.x() - given.cx_px) * given.sensor.dx_prime_mm(),
            (point.seen_px.y() - given.cy_px) * given.sensor.dy_mm};
}

// Least squares with columns of like size; empty where they do not determine the unknowns.
std::optional<Eigen::VectorXd> solved(Eigen::MatrixXd A, const Eigen::VectorXd& b) {
    const Eigen::RowVectorXd sizes = A.colwise().norm();
    if (!(sizes.minCoeff() > 0.0) || !sizes.allFinite()) {
        return std::nullopt;
    }
    A.array().rowwise() /= sizes.array();
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
    qr.setThreshold(1e-10);
    if (qr.rank() < A.cols()) {
        return std::nullopt;
    }
    return qr.solve(b).cwiseQuotient(sizes.transpose());
}

// The points about another origin, and their places on the sensor.
struct Moved {
    Eigen::Vector3d origin_mm = Eigen::Vector3d::Zero();
    Eigen::Matrix3Xd world_mm;
    Eigen::Matrix2Xd sensor_mm;
};

// About the outermost point of each quarter of the picture, where its y does not vanish.
std::vector<Moved> moved(const std::vector<SeenPoint>& points, const TsaiLens& given) {
    Moved all;
    const auto n = static_cast<Eigen::Index>(points.size());
    all.world_mm.resize(3, n);
    all.sensor_mm.resize(2, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        all.world_mm.col(i) = points[static_cast<std::size_t>(i)].in_world_mm;
        all.sensor_mm.col(i) = on_sensor_mm(points[static_cast<std::size_t>(i)], given);
    }
    const double highest = all.sensor_mm.row(1).cwiseAbs().maxCoeff();
    std::vector<Eigen::Index> origins;
    for (const auto& quarter : {Eigen::RowVector2d(1, 1), Eigen::RowVector2d(-1, 1),
                                Eigen::RowVector2d(1, -1), Eigen::RowVector2d(-1, -1)}) {
        Eigen::Index outermost = 0;
        (quarter * all.sensor_mm).maxCoeff(&outermost);
        const bool tried = std::find(origins.begin(), origins.end(), outermost) != origins.end();
        if (!tried && std::abs(all.sensor_mm(1, outermost)) > 0.1 * highest) {
            origins.push_back(outermost);
        }
    }
    std::vector<Moved> result;
    for (const Eigen::Index origin : origins) {
        result.push_back(all);
        result.back().origin_mm = all.world_mm.col(origin);
        result.back().world_mm.colwise() -= result.back().origin_mm;
    }
    return result;
}

// What the first half of the linear stage finds, about the moved origin; sensor_mm is freed of s_x.
struct Aligned {
    Eigen::Matrix3d R;
    double tx_mm = 0.0;
    double ty_mm = 0.0;
    double sx = 1.0;
    Moved points;
};

// True where the points come out on their pixels' side of the centre.
bool on_the_right_side(const Eigen::RowVector3d& r1, const Eigen::RowVector3d& r2, double tx,
                       double ty, const Moved& points) {
    const Eigen::RowVectorXd x = (r1 * points.world_mm).array() + tx;
    const Eigen::RowVectorXd y = (r2 * points.world_mm).array() + ty;
    return x.dot(points.sensor_mm.row(0)) + y.dot(points.sensor_mm.row(1)) > 0.0;
}

std::optional<Aligned> aligned(Moved points) {
    const auto n = points.world_mm.cols();
    const auto X = points.sensor_mm.row(0).transpose();
    const auto Y = points.sensor_mm.row(1).transpose();
    Eigen::MatrixXd A(n, 7);
    A.leftCols<3>() = points.world_mm.transpose().array().colwise() * Y.array();
    A.col(3) = Y;
    A.rightCols<3>() = points.world_mm.transpose().array().colwise() * -X.array();
    const auto U = solved(A, X);
    if (!U) {
        return std::nullopt;
    }
    const double size = U->tail<3>().norm();
    if (!(size > 0.0) || !(U->head<3>().norm() > 0.0)) {
        return std::nullopt;
    }
    Aligned result;
    result.ty_mm = 1.0 / size;
    result.sx = U->head<3>().norm() / size;
    Eigen::RowVector3d r1 = U->head<3>().normalized();
    Eigen::RowVector3d r2 = U->tail<3>().normalized();
    result.tx_mm = (*U)[3] * result.ty_mm / result.sx;
    points.sensor_mm.row(0) /= result.sx;
    if (!on_the_right_side(r1, r2, result.tx_mm, result.ty_mm, points)) {
        r1 = -r1;
        r2 = -r2;
        result.tx_mm = -result.tx_mm;
        result.ty_mm = -result.ty_mm;
    }
    result.R << r1, r2, r1.cross(r2);
    result.R = nearest_rotation(result.R);
    result.points = std::move(points);
    return result;
}

// The plane's two rotations, of which f > 0 chooses one.
std::vector<Aligned> aligned_on_plane(Moved points) {
    const auto n = points.world_mm.cols();
    const auto X = points.sensor_mm.row(0).transpose();
    const auto Y = points.sensor_mm.row(1).transpose();
    Eigen::MatrixXd A(n, 5);
    A.leftCols<2>() = points.world_mm.topRows<2>().transpose().array().colwise() * Y.array();
    A.col(2) = Y;
    A.rightCols<2>() = points.world_mm.topRows<2>().transpose().array().colwise() * -X.array();
    const auto U = solved(A, X);
    if (!U) {
        return {};
    }
    // r1 and r2, over T_y, without their last entries: T_y from their lengths and their square.
    const Eigen::RowVector2d a = U->head<2>();
    const Eigen::RowVector2d b = U->tail<2>();
    const double sum = a.squaredNorm() + b.squaredNorm();
    const double cross = a.x() * b.y() - a.y() * b.x();
    const double inner = std::sqrt(std::max(0.0, sum * sum - 4.0 * cross * cross));
    const double ty_squared = 2.0 / (sum + inner);
    if (!std::isfinite(ty_squared)) {
        return {};
    }
    double ty = std::sqrt(ty_squared);
    Eigen::RowVector3d r1(a.x() * ty, a.y() * ty, 0.0);
    Eigen::RowVector3d r2(b.x() * ty, b.y() * ty, 0.0);
    double tx = (*U)[2] * ty;
    if (!on_the_right_side(r1, r2, tx, ty, points)) {
        r1 = -r1;
        r2 = -r2;
        tx = -tx;
        ty = -ty;
    }
    r1.z() = std::sqrt(std::max(0.0, 1.0 - r1.squaredNorm()));
    r2.z() = std::sqrt(std::max(0.0, 1.0 - r2.squaredNorm()));
    if (r1.head<2>().dot(r2.head<2>()) > 0.0) {
        r2.z() = -r2.z();
    }
    std::vector<Aligned> both;
    for (const double sign : {1.0, -1.0}) {
        Aligned one{{}, tx, ty, 1.0, points};
        r1.z() *= sign;
        r2.z() *= sign;
        one.R << r1, r2, r1.cross(r2);
        one.R = nearest_rotation(one.R);
        both.push_back(std::move(one));
    }
    return both;
}

struct Depth {
    double f_mm = 0.0;
    double tz_mm = 0.0;
    double kappa1_per_mm2 = 0.0;
};

// f x - X T_z [- kappa1 X r^2 w - kappa1 T_z X r^2] = X w, for x and y alike, w = r3 p.
std::optional<Depth> depth_of(const Aligned& found, bool with_kappa) {
    const auto n = found.points.world_mm.cols();
    Eigen::Matrix3Xd turned = found.R * found.points.world_mm;
    turned.row(0).array() += found.tx_mm;
    turned.row(1).array() += found.ty_mm;
    const Eigen::ArrayXd w = turned.row(2).transpose().array();
    const Eigen::ArrayXd r2 = found.points.sensor_mm.colwise().squaredNorm().transpose().array();
    Eigen::MatrixXd A(2 * n, with_kappa ? 4 : 2);
    Eigen::VectorXd b(2 * n);
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::ArrayXd seen = found.points.sensor_mm.row(axis).transpose().array();
        A.col(0).segment(axis * n, n) = turned.row(axis).transpose();
        A.col(1).segment(axis * n, n) = -seen;
        if (with_kappa) {
            A.col(2).segment(axis * n, n) = -seen * r2 * w;
            A.col(3).segment(axis * n, n) = -seen * r2;
        }
        b.segment(axis * n, n) = seen * w;
    }
    const auto solution = solved(A, b);
    if (!solution) {
        return std::nullopt;
    }
    return Depth{(*solution)[0], (*solution)[1], with_kappa ? (*solution)[2] : 0.0};
}

void add_candidates(const Aligned& found, const TsaiLens& given,
                    std::vector<TsaiView>& candidates) {
    for (const bool with_kappa : {false, true}) {
        const auto depth = depth_of(found, with_kappa);
        if (!depth || !(depth->f_mm > 0.0)) {
            continue;
        }
        const Eigen::RowVectorXd z =
            (found.R.row(2) * found.points.world_mm).array() + depth->tz_mm;
        if (!(z.minCoeff() > 0.0)) {
            continue;
        }
        TsaiView view;
        view.lens = given;
        view.lens.f_mm = depth->f_mm;
        view.lens.kappa1_per_mm2 = depth->kappa1_per_mm2;
        view.lens.sx = given.sx * found.sx;
        view.T_camera_from_world.R = found.R;
        view.T_camera_from_world.t_mm = Eigen::Vector3d(found.tx_mm, found.ty_mm, depth->tz_mm) -
                                        found.R * found.points.origin_mm;
        candidates.push_back(view);
    }
}

}  // namespace

std::vector<TsaiView> tsai_linear(const std::vector<SeenPoint>& points, const TsaiLens& given) {
    TsaiLens bare = given;
    bare.sx = 1.0;  // it is found anew
    std::vector<TsaiView> candidates;
    for (const Moved& about : moved(points, bare)) {
        if (const auto found = aligned(about)) {
            add_candidates(*found, bare, candidates);
        }
    }
    return candidates;
}

std::vector<TsaiView> tsai_linear_coplanar(const std::vector<SeenPoint>& points,
                                           const TsaiLens& given) {
    const PointLayout layout = layout_of(points);
    const RigidTransform T_plane_from_world{layout.axes.transpose(),
                                            -(layout.axes.transpose() * layout.mean_mm)};
    std::vector<SeenPoint> on_plane = points;
    for (SeenPoint& point : on_plane) {
        point.in_world_mm = T_plane_from_world * point.in_world_mm;
    }
    std::vector<TsaiView> candidates;
    for (Moved& about : moved(on_plane, given)) {
        about.sensor_mm.row(0) /= given.sx;
        for (const Aligned& found : aligned_on_plane(std::move(about))) {
            add_candidates(found, given, candidates);
        }
    }
    for (TsaiView& view : candidates) {
        view.T_camera_from_world = view.T_camera_from_world * T_plane_from_world;
    }
    return candidates;
}

}  // namespace kambara
