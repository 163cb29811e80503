#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Writes a path of eyes as `lumi render --path` reads it: {"eyes": [{"camera", "cam_from_world"},
/// ...]}, whole or not at all. Throws Error (E-FILE-WRITE).
void write_path_file(const std::filesystem::path& path, std::span<const Eye> eyes);

/// lumi-path-0001.json, or the first number that is free in the folder.
[[nodiscard]] std::filesystem::path next_path_file(const std::filesystem::path& folder);

/// The eyes of a window while its path is recorded.
class PathRecording {
 public:
    /// Appends an eye that differs from the last, unless its size does: a path has one. Returns
    /// what people are told.
    std::string append(const Eye& eye);
    /// Writes what was recorded into the folder, and forgets it. Returns what people are told:
    /// nothing where nothing was recorded.
    std::string end(const std::filesystem::path& folder);

 private:
    std::vector<Eye> eyes_;
};

}  // namespace lumi
