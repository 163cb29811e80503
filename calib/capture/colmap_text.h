#pragma once

#include <filesystem>

#include "calib/capture/colmap_ids.h"

namespace lumi {

/// cameras.txt, images.txt and points3D.txt (the last may be missing) as they stand; names with
/// spaces are kept.
[[nodiscard]] ColmapRecords read_colmap_text(const std::filesystem::path& folder);

}  // namespace lumi
