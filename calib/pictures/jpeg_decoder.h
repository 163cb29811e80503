#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "calib/pictures/image_io.h"
#include "calib/pictures/stored_picture.h"

namespace lumi {

/// Size from the JPEG header. Throws Error (E-IMAGE-TRUNCATED, E-IMAGE-FORMAT).
[[nodiscard]] ImageSize jpeg_size(std::span<const std::uint8_t> bytes,
                                  const std::filesystem::path& path);

/// The raster of a JPEG. A warning of the decoder (missing scan lines, corrupt data) is an Error:
/// common readers return half-grey pictures without a word. Only padding before the end marker is
/// passed over. Throws Error: E-IMAGE-TRUNCATED, E-IMAGE-TOOBIG, E-IMAGE-FORMAT (a lossless one, or
/// one of 12 bits).
[[nodiscard]] StoredPicture decode_jpeg(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                                        const std::filesystem::path& path);

/// The bytes of a JPEG without chroma subsampling, quality 1 to 100.
[[nodiscard]] std::vector<std::uint8_t> encode_jpeg(const ColorImage& image, int quality);

}  // namespace lumi
