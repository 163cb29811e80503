#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "calib/pictures/image_io.h"
#include "calib/pictures/stored_picture.h"
#include "calib/work/whole_file.h"

namespace lumi {

/// The primary picture of an HEIF file (HEIC, as telephones write it, and AVIF) through libheif, as
/// the sensor had it: what turns, mirrors or crops the display is not applied.

/// Throws Error (E-IMAGE-TRUNCATED).
[[nodiscard]] ImageSize heif_size(std::span<const std::uint8_t> bytes,
                                  const std::filesystem::path& path);

/// Rasters of more than 8 bits fill 16. Whatever the decoder complains about is an Error
/// (E-IMAGE-TRUNCATED), and so are more than `max_pixels` (E-IMAGE-TOOBIG, before decoding).
[[nodiscard]] StoredPicture decode_heif(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                                        const std::filesystem::path& path);

/// Its EXIF from the TIFF header on; empty when it has none, or cannot be read.
[[nodiscard]] Bytes heif_exif(std::span<const std::uint8_t> bytes);

}  // namespace lumi
