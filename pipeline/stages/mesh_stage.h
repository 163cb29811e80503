#pragma once

#include <filesystem>

#include "meshing/cameras/camera_mesh_builder.h"
#include "pipeline/workspace/done_marker.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// As a workspace's configuration says. Throws Error like read_camera_mesh_options.
[[nodiscard]] CameraMeshOptions camera_mesh_options_of(const WorkspaceLayout& workspace);

/// Poses of the views in use -> camera_mesh.ply and camera_mesh.svg in `folder`. The mesh names
/// views by their index in `capture`.
[[nodiscard]] StageEvidence run_mesh_stage(const Capture& capture, const CameraMeshOptions& options,
                                           const std::filesystem::path& folder);

}  // namespace lumi
