#pragma once

#include <filesystem>
#include <string>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// Writes the picture as PNG and, beside it with the ending .json, what it shows: package, mode and
/// the other options that the window offers, and the eye's camera and pose, doubles to the bit.
/// `lumi render --eye` draws the same frame from it. Throws Error (E-FILE-WRITE).
void write_screenshot(const std::filesystem::path& path, const Frame& frame, const Eye& eye,
                      const RenderOptions& options, Exposures exposures,
                      const std::string& lumigraph_name);

/// The first of lumi-0001.png, lumi-0002.png, ... that is not in the folder yet.
[[nodiscard]] std::filesystem::path next_screenshot_path(const std::filesystem::path& folder);

}  // namespace lumi
