#pragma once

#include <filesystem>

#include "calib/work/whole_file.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// Binary little-endian PLY: vertices (x y z, int view, uchar virtual, and of cameras without a
/// surface sight_x sight_y sight_z), faces (vertex_indices), construction and scene centre in
/// comments; shells follow in the same lists (comment shell). The reader checks counts against the
/// file's size before it allocates and throws Error (E-PLY-READ) with what was expected.
void write_camera_mesh_ply(const std::filesystem::path& path, const CameraMesh& mesh);
[[nodiscard]] CameraMesh read_camera_mesh_ply(const std::filesystem::path& path);

/// The same file in memory; `path` is for messages.
[[nodiscard]] Bytes camera_mesh_ply(const CameraMesh& mesh);
[[nodiscard]] CameraMesh parse_camera_mesh_ply(const Bytes& bytes,
                                               const std::filesystem::path& path);

}  // namespace lumi
