#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/cameras/scene_centre.h"

namespace lumi {

/// The cameras as the scene centre sees them: one entry a camera, no two in one direction.
struct CameraStar {
    Eigen::Vector3d centre_in_world = Eigen::Vector3d::Zero();
    std::vector<OpticalAxis> axes;
    std::vector<Eigen::Vector3d> directions;  ///< From the centre to the camera, of length one.
    std::vector<double> distances;
    int hidden_cameras = 0;  ///< Left out because another camera stands in the same direction.
};

/// Of several cameras in the same direction (within 1e-6 radians) the one whose distance is
/// nearest to the median distance of all cameras is kept; of equals the first. A surface that is
/// seen once in every direction can hold no more.
[[nodiscard]] CameraStar camera_star(const std::vector<OpticalAxis>& axes,
                                     const Eigen::Vector3d& centre_in_world);

/// Whether camera `a` of the star rather than `b` is kept by that rule: the nearer to the usual
/// distance; of those that are equally near, up to rounding, the first.
[[nodiscard]] bool stands_for_both(const CameraStar& star, std::size_t a, std::size_t b,
                                   double usual_distance);

[[nodiscard]] double largest_distance(const CameraStar& star);

/// The star without the cameras whose entry in `keep` is 0; they count as hidden.
[[nodiscard]] CameraStar kept_cameras(const CameraStar& star, const std::vector<char>& keep);

}  // namespace lumi
