#pragma once

#include <filesystem>
#include <span>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Writes a path of eyes as `lumi render --path` reads it: {"eyes": [{"camera", "cam_from_world"},
/// ...]}, whole or not at all. Throws Error (E-FILE-WRITE).
void write_path_file(const std::filesystem::path& path, std::span<const Eye> eyes);

/// lumi-path-0001.json, or the first number that is free in the folder.
[[nodiscard]] std::filesystem::path next_path_file(const std::filesystem::path& folder);

}  // namespace lumi
