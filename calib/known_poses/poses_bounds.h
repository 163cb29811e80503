#pragma once

#include <filesystem>

#include "calib/known_poses/known_poses.h"

namespace lumi {

/// `poses_bounds.npy` of LLFF: for each photograph, sorted by name, a 3x5 matrix [down, right,
/// back, centre, (height, width, focal length)] by rows, then near and far, which are not used.
/// Throws Error: E-IMPORT-NPY, E-IMPORT-POSES. Reference: github.com/Fyusion/LLFF, "Using your own
/// poses".
[[nodiscard]] KnownPoses read_poses_bounds(const std::filesystem::path& path);

}  // namespace lumi
