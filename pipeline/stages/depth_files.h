#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "meshing/surface/depth_map.h"

namespace lumi {

/// Writes STEM.inverse_depth.tif (32-bit) and STEM.confidence.png, which keep every bit, and
/// STEM.inverse_depth.png to look at: near bright and far dark, on one scale for all views.
void write_depth_files(const std::filesystem::path& folder, const std::vector<std::string>& stems,
                       const std::vector<DepthMap>& depth_maps, int threads);
[[nodiscard]] std::vector<DepthMap> read_depth_files(const std::filesystem::path& folder,
                                                     const std::vector<std::string>& stems,
                                                     int threads);

}  // namespace lumi
