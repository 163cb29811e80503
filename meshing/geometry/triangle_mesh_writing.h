#pragma once

#include <filesystem>

#include "meshing/geometry/triangle_mesh.h"

namespace lumi {

/// Binary little-endian PLY: x y z, nx ny nz and red green blue where there are any, and
/// vertex_indices. Places are floats, or doubles where floats would round them by more than a
/// thousandth of the triangles' sides: far from the world's origin. Written whole or not at all.
void write_triangle_mesh_ply(const std::filesystem::path& path, const TriangleMesh& mesh);

}  // namespace lumi
