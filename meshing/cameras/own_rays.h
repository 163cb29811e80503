#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// The weight that cameras have, on average, on the rays between them and the scene points in their
/// pictures: 1 is the paper's rule, by which a ray through a camera's centre is drawn from that
/// camera alone. It is less where cameras were slid (slide.h), and where a mesh that is looked out
/// of is not convex: behind a camera that stands in a hollow of it, the ray crosses another face,
/// nearer to the scene. Over at most a thousand rays, evenly chosen; 1 where there are none.
[[nodiscard]] double own_ray_share(const Capture& capture, const CameraMesh& mesh,
                                   const std::vector<Eigen::Vector3d>& scene_in_world);

}  // namespace lumi
