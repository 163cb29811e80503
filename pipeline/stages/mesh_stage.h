#pragma once

#include <filesystem>

#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {

/// As a configuration says, that of a workspace or of a package. Throws Error like
/// ConfigSection::from_file and read_camera_mesh_options.
[[nodiscard]] CameraMeshOptions camera_mesh_options_of(const std::filesystem::path& configuration);

/// Poses of the views in use -> camera_mesh.ply and camera_mesh.svg in `folder`. The mesh names
/// views by their index in `capture`.
[[nodiscard]] StageEvidence run_mesh_stage(const Capture& capture, const CameraMeshOptions& options,
                                           const std::filesystem::path& folder);

}  // namespace lumi
