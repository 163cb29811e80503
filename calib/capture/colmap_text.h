#pragma once

#include <filesystem>

#include "calib/capture/colmap_ids.h"

namespace lumi {

/// A cameras.txt by the ids of its cameras. Throws Error (E-COLMAP-MODEL, E-COLMAP-LENS) with file
/// and line.
[[nodiscard]] std::map<std::uint32_t, Camera> read_colmap_cameras(
    const std::filesystem::path& cameras_txt);

/// cameras.txt, images.txt and points3D.txt (the last may be missing) as they stand; names with
/// spaces are kept.
[[nodiscard]] ColmapRecords read_colmap_text(const std::filesystem::path& folder);

}  // namespace lumi
