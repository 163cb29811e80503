#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// Distance from the scene centre to the nearest face plane; negative when the centre lies outside
/// one. Scene points within it are in the kernel: every ray through them crosses exactly one face.
[[nodiscard]] double kernel_radius(const CameraMesh& mesh);

/// Faces whose plane has more than `tolerated_share` of the points on its outer side.
[[nodiscard]] int faces_with_scene_outside(const CameraMesh& mesh,
                                           const std::vector<Eigen::Vector3d>& points_in_world,
                                           double tolerated_share);

}  // namespace lumi
