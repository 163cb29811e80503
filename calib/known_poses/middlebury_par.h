#pragma once

#include <filesystem>

#include "calib/known_poses/known_poses.h"

namespace lumi {

/// `*_par.txt` of the Middlebury multi-view benchmark: a count, then for each photograph its name,
/// K (by rows), the rotation and the translation camera-from-world. Pixels count from pixel centres
/// and are moved by half a pixel; the size is that of the photographs. Throws Error
/// (E-IMPORT-POSES). Reference: vision.middlebury.edu/mview/data.
[[nodiscard]] KnownPoses read_middlebury_par(const std::filesystem::path& path);

}  // namespace lumi
