#pragma once

#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// The camera mesh from above and from the side as one SVG document: faces (those that carry a
/// virtual vertex lighter and cut off at the frame), the frusta of the cameras with the names of
/// their views, cameras that are no vertex in grey, shells over close-ups in a colour of their own,
/// and scene points in their colours. "Up" is the mean of the photographs' upward directions.
[[nodiscard]] std::string camera_mesh_svg(const Capture& capture,
                                          const std::vector<int>& view_indices,
                                          const CameraMesh& mesh,
                                          const std::vector<Rigid3>& suggested = {});

}  // namespace lumi
