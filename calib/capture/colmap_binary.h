#pragma once

#include <filesystem>

#include "calib/capture/colmap_ids.h"

namespace lumi {

/// cameras.bin, images.bin and points3D.bin (the last may be missing), little-endian, as they
/// stand.
[[nodiscard]] ColmapRecords read_colmap_binary(const std::filesystem::path& folder);

}  // namespace lumi
