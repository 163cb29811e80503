#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "calib/capture/image.h"
#include "calib/pictures/stored_picture.h"
#include "calib/work/whole_file.h"

namespace lumi {

/// Lossless PNG, the same bytes for the same pixels: 8-bit colour, 8-bit grey, 16-bit grey.
[[nodiscard]] Bytes encode_png(const ColorImage& image, const std::filesystem::path& path);
[[nodiscard]] Bytes encode_png(const GrayImage& image, const std::filesystem::path& path);
[[nodiscard]] Bytes encode_png(const Image<std::uint16_t>& image,
                               const std::filesystem::path& path);

/// The raster of a PNG in memory; `path` is for messages. Stored and colour ones (as 8-bit sRGB)
/// accept any PNG, transparent ones as before black: a cut-out stands before a plain background.
/// The grey ones accept a single channel of their depth only. Throws Error: E-IMAGE-FORMAT (not
/// such a PNG), E-IMAGE-TRUNCATED, E-IMAGE-TOOBIG (more than `max_pixels`, checked before
/// decoding).
[[nodiscard]] StoredPicture decode_png(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                                       const std::filesystem::path& path);
[[nodiscard]] ColorImage decode_color_png(std::span<const std::uint8_t> bytes,
                                          std::size_t max_pixels,
                                          const std::filesystem::path& path);
[[nodiscard]] GrayImage decode_gray_png(std::span<const std::uint8_t> bytes, std::size_t max_pixels,
                                        const std::filesystem::path& path);
[[nodiscard]] Image<std::uint16_t> decode_gray16_png(std::span<const std::uint8_t> bytes,
                                                     std::size_t max_pixels,
                                                     const std::filesystem::path& path);

}  // namespace lumi
