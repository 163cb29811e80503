#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "calib/pictures/image_io.h"
#include "calib/pictures/stored_picture.h"
#include "calib/work/whole_file.h"

namespace lumi {

/// Size from the header of a WebP picture. Throws Error (E-IMAGE-TRUNCATED).
[[nodiscard]] ImageSize webp_size(std::span<const std::uint8_t> bytes,
                                  const std::filesystem::path& path);

/// The raster of a WebP picture through libwebp, with its ICC profile. Throws Error
/// (E-IMAGE-TRUNCATED, E-IMAGE-TOOBIG, and E-IMAGE-FORMAT for an animation).
[[nodiscard]] StoredPicture decode_webp(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                                        const std::filesystem::path& path);

/// Its EXIF from the TIFF header on; empty when it has none.
[[nodiscard]] Bytes webp_exif(std::span<const std::uint8_t> bytes);

}  // namespace lumi
