#pragma once

#include <filesystem>
#include <optional>

#include "calib/pictures/stored_picture.h"

namespace lumi {

/// What an MP4 or QuickTime file says that the colours of its first track mean (its `colr` box:
/// ISO/IEC 14496-12, 12.1.5, or QuickTime's `nclc`); empty where it says nothing, and for other
/// files. Reads the headers alone, wherever they are.
[[nodiscard]] std::optional<CodedColors> coded_colors_of_video(const std::filesystem::path& video);

}  // namespace lumi
