#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string_view>

#include "calib/pictures/image_io.h"

namespace lumi {

/// The picture formats that lumi reads; nothing else reaches a decoder.
enum class ImageFormat { kJpeg, kPng, kTiff, kHeif, kWebp };

/// The formats in words, for those who are told to export something else as one of them.
inline constexpr std::string_view kImageFormats = "JPEG, PNG, TIFF, HEIC, AVIF or WebP";

/// By the first bytes, whatever the file is called.
[[nodiscard]] std::optional<ImageFormat> image_format_of(std::span<const std::uint8_t> bytes);
/// The same of a file; none of one that cannot be read.
[[nodiscard]] std::optional<ImageFormat> image_format_of(const std::filesystem::path& file);

/// Size from the PNG header and proof that the file reaches its IEND chunk with every checksum
/// right. Throws Error (E-IMAGE-TRUNCATED).
[[nodiscard]] ImageSize check_png(std::span<const std::uint8_t> bytes,
                                  const std::filesystem::path& path);

/// Throws Error (E-IMAGE-TOOBIG, E-IMAGE-TRUNCATED) unless the size is positive and within budget.
void check_image_size(ImageSize size, std::size_t max_pixels, const std::filesystem::path& path);

[[noreturn]] void refuse_truncated_image(const std::filesystem::path& path,
                                         const std::string& reason);

/// Throws Error (E-IMAGE-FORMAT): whole, as far as can be told, but coded in a way that is not
/// decoded, such as lossless JPEG.
[[noreturn]] void refuse_unsupported_image(const std::filesystem::path& path,
                                           const std::string& reason);

}  // namespace lumi
