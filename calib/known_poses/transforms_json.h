#pragma once

#include <filesystem>

#include "calib/known_poses/known_poses.h"

namespace lumi {

/// `transforms.json` of nerfstudio and instant-ngp: world-from-camera matrices with OpenGL axes
/// (+y up, looking along -z), the lens for the whole file or for each frame, in pixels or as
/// `camera_angle_x` and `camera_angle_y`, with its distortion. Nesting deeper than 32 is refused
/// before it can exhaust the stack. Throws Error: E-IMPORT-JSON, E-IMPORT-LENS, E-IMPORT-POSES.
/// Reference: docs.nerf.studio/quickstart/data_conventions.html.
[[nodiscard]] KnownPoses read_transforms_json(const std::filesystem::path& path);

}  // namespace lumi
