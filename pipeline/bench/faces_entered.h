#pragma once

#include <Eigen/Core>

#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// How many faces the line through `point` along `direction` enters from outside, every face asked:
/// what a search by neighbours is judged by. A consistent mesh has one for each ray to the scene.
[[nodiscard]] int faces_entered(const CameraMesh& mesh, const Eigen::Vector3d& point,
                                const Eigen::Vector3d& direction);

}  // namespace lumi
