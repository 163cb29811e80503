#pragma once

#include <vector>

#include "meshing/cameras/camera_directions.h"
#include "meshing/cameras/spherical_triangulation.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// The faces that cameras really stand around: those whose empty circle is no wider than three
/// times the median and never wider than 85 degrees. A camera that would lose its last face keeps
/// the smallest.
[[nodiscard]] std::vector<SphericalFace> without_far_side(const std::vector<SphericalFace>& faces,
                                                          std::size_t camera_count);

/// Continues the border of an open mesh outwards around the scene: rings of virtual vertices, each
/// repeating its border camera, so that rays from beyond the capture are answered by the border's
/// cameras, continuously.
void add_skirt(CameraMesh& mesh, const std::vector<CameraDirection>& cameras);

}  // namespace lumi
