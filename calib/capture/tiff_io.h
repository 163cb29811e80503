#pragma once

#include <filesystem>

#include "calib/capture/image_io.h"

namespace lumi {

/// TIFF through OpenImageIO: the header is checked before anything is decoded. Throws Error
/// (E-IMAGE-TRUNCATED, E-IMAGE-TOOBIG).
[[nodiscard]] ImageSize tiff_size(const std::filesystem::path& path);
[[nodiscard]] ColorImage read_color_tiff(const std::filesystem::path& path, std::size_t max_pixels);

}  // namespace lumi
