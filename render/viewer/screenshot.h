#pragma once

#include <filesystem>
#include <string>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// Writes the picture as PNG and, beside it with the ending .json, what it shows: package, mode and
/// the other options that the window offers, and the eye's camera and pose, doubles to the bit.
/// `lumi render --eye` draws the same frame from it. Throws Error (E-FILE-WRITE, and what
/// check_screenshot_out throws).
void write_screenshot(const std::filesystem::path& path, const Frame& frame, const Eye& eye,
                      const RenderOptions& options, Exposures exposures,
                      const std::string& lumigraph_name);

/// To be called before anything is drawn. Throws Error (E-SCREENSHOT-OUT) where the pose would take
/// the place of a file that holds none.
void check_screenshot_out(const std::filesystem::path& path);

/// The first of lumi-0001.png, lumi-0002.png, ... that is not in the folder yet, nor its pose.
[[nodiscard]] std::filesystem::path next_screenshot_path(const std::filesystem::path& folder);

}  // namespace lumi
