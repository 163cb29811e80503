#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <span>
#include <vector>

namespace lumi {

/// Of a triangle, by two of its sides: positive where the first turns to the second as x to y.
[[nodiscard]] inline double signed_doubled_area(const Eigen::Vector2d& ab,
                                                const Eigen::Vector2d& ac) {
    return ab.x() * ac.y() - ab.y() * ac.x();
}

/// The same without its sign, in a picture.
[[nodiscard]] inline double doubled_area_px2(const Eigen::Vector2d& ab, const Eigen::Vector2d& ac) {
    return std::abs(signed_doubled_area(ab, ac));
}

/// Of a convex polygon of a picture; 0 with less than three corners.
[[nodiscard]] double area_px2(const std::vector<Eigen::Vector2d>& corners_px);

/// Around all corners; empty without any.
[[nodiscard]] Eigen::AlignedBox2d bounding_box(std::span<const Eigen::Vector2d> corners);

}  // namespace lumi
