#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// Where a camera stands and which way it looks.
struct OpticalAxis {
    int view_index = 0;
    Eigen::Vector3d centre_in_world = Eigen::Vector3d::Zero();
    Eigen::Vector3d direction_in_world = Eigen::Vector3d::UnitZ();  ///< Of length one.
    double depth = 0.0;  ///< Median z of the scene points it sees; 0 when it sees none.
};

[[nodiscard]] std::vector<OpticalAxis> optical_axes(const Capture& capture,
                                                    const std::vector<int>& view_indices);

/// Scene points that at least one of the listed views has seen (all points when no point has a
/// track), thinned evenly to at most `max_points`.
[[nodiscard]] std::vector<Eigen::Vector3d> visible_points(const Capture& capture,
                                                          const std::vector<int>& view_indices,
                                                          std::size_t max_points);

/// The point that the cameras look at: least squares of its distances from the optical axes, and,
/// with a small weight, of its depth along each axis from the median depth that the camera sees.
/// Converging axes decide by themselves; for parallel ones the seen depth decides how far away the
/// point is. Robust by iterated Cauchy weights. `axes` must not be empty.
[[nodiscard]] Eigen::Vector3d estimate_scene_centre(const std::vector<OpticalAxis>& axes);

/// The median distance of the cameras from a point.
[[nodiscard]] double median_distance(const std::vector<OpticalAxis>& axes,
                                     const Eigen::Vector3d& point_in_world);

/// Compass search for the centre with the largest value within `reach` of `start`, by steps along
/// the world axes of half the reach down to a 32nd of it. A step must gain more than `least_gain`,
/// so that rounding does not lead it across a plateau. Ends after `most_evaluations` of `value`.
[[nodiscard]] Eigen::Vector3d improve_scene_centre(
    const Eigen::Vector3d& start, double reach, double least_gain, int most_evaluations,
    const std::function<double(const Eigen::Vector3d&)>& value);

}  // namespace lumi
