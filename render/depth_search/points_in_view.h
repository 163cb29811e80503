#pragma once

#include <Eigen/Core>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Points that an eye sees, one a column: eye + direction / inverse depth, perhaps infinitely far.
struct RayPoints {
    Eigen::Matrix3Xd directions_in_world;
    Eigen::RowVectorXd inverse_depths;  ///< Of 1 / (lengths of the directions).
};

/// The same points as a view sees them. Of those behind it nothing but that counts.
struct PointsInView {
    using Row = Eigen::Array<double, 1, Eigen::Dynamic>;
    Row x_px;
    Row y_px;
    Eigen::Array<bool, 1, Eigen::Dynamic> are_before;
    Row angles_rad;  ///< At the point, between eye and view; large ones are taken for larger.

    /// How far inside of the photograph they lie, in its pixels; negative outside.
    [[nodiscard]] Row to_border_px(const Camera& camera) const;
};

[[nodiscard]] PointsInView seen_by(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
                                   const RayPoints& points);

}  // namespace lumi
