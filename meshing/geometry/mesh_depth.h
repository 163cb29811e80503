#pragma once

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/geometry/triangle_mesh.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Depth of a triangle mesh as a view sees it, by a z-buffer: the nearest surface at the centre
/// of each pixel, front or back. Confidence kKnown on the mesh, kUnseen beside it. Triangles that
/// reach behind the camera are cut there.
[[nodiscard]] DepthMap mesh_depth(const DepthView& view, const TriangleMesh& mesh);

}  // namespace lumi
