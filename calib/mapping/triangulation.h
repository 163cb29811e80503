#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calib/capture/rigid3.h"

namespace lumi {

/// A direction in which a camera of known place sees something.
struct Sighting {
    Rigid3 cam_from_world;
    Eigen::Vector2d ray = Eigen::Vector2d::Zero();  ///< At depth 1, free of lens distortion.
    double focal_length_px = 1;                     ///< Turns distances at depth 1 into pixels.
};

struct TriangulationOptions {
    double max_error_px = 4.0;     ///< Of a sighting that agrees. > 0.
    double min_angle_rad = 0.026;  ///< Between the two rays that differ most; 1.5 degrees. > 0.
};

struct TriangulatedPoint {
    Eigen::Vector3d position_in_world = Eigen::Vector3d::Zero();
    std::vector<char> is_inlier;  ///< One per sighting.
};

/// The point that most sightings agree on: the pairs of rays that differ most in direction each
/// propose one (the middle of where they pass closest), and the best is refined by least squares
/// over those that agree. Empty when fewer than two do, or their rays are nearly parallel.
[[nodiscard]] std::optional<TriangulatedPoint> triangulate(std::span<const Sighting> sightings,
                                                           const TriangulationOptions& options);

/// Gauss-Newton over the sightings that are marked, in the plane at depth 1, weighted as pixels.
/// Returns the point as it was when a step fails.
[[nodiscard]] Eigen::Vector3d refined_point(std::span<const Sighting> sightings,
                                            const std::vector<char>& is_used,
                                            const Eigen::Vector3d& point_in_world);

/// In pixels; infinite when the point is not in front of the camera.
[[nodiscard]] double sighting_error_px(const Sighting& sighting,
                                       const Eigen::Vector3d& point_in_world);

/// The largest angle between rays from marked sightings to the point.
[[nodiscard]] double largest_angle_rad(std::span<const Sighting> sightings,
                                       const std::vector<char>& is_used,
                                       const Eigen::Vector3d& point_in_world);

}  // namespace lumi
