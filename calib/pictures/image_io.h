#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "calib/capture/image.h"

namespace lumi {

/// What was done to the numbers of a file to make them 8-bit sRGB; nothing for most.
struct ColorConversion {
    std::string from;            ///< Such as "Display P3" or "linear light"; empty: they were sRGB.
    std::string profile_fault;   ///< Why the embedded profile was passed over; empty: it was not.
    double clipped_share = 0.0;  ///< Of the pixels: brighter than white, and white in the picture.
    double hidden_share = 0.0;   ///< Of the pixels: wholly transparent, and black in the picture.
};

struct SrgbPicture {
    ColorImage picture;
    GrayImage shown;  ///< 0 where the file is wholly transparent, else 255; empty: nowhere.
    ColorConversion conversion;
};

/// The raster of a JPEG, PNG, TIFF, HEIF or WebP file as 8-bit sRGB, the EXIF orientation not
/// applied. Converted are the numbers of an embedded ICC profile or of coded colours, of Adobe RGB
/// by EXIF alone, of floats (which are light, unless the file says otherwise) and of inks; what is
/// transparent is seen before black. Throws Error: E-IMAGE-FORMAT (not one of these formats, by
/// content, or coded for HDR by PQ or in a way that its decoder lacks), E-IMAGE-TRUNCATED (the file
/// ends early or its decoder warns), E-IMAGE-TOOBIG (more than `max_pixels`, checked before
/// decoding), E-FILE-READ.
[[nodiscard]] SrgbPicture read_srgb_picture(const std::filesystem::path& path,
                                            std::size_t max_pixels = std::size_t{1} << 28);
/// The same, where nobody asks what was done.
[[nodiscard]] ColorImage read_color_image(const std::filesystem::path& path,
                                          std::size_t max_pixels = std::size_t{1} << 28);

struct ImageSize {
    int width_px = 0;
    int height_px = 0;
};

/// Width and height from the header; nothing is decoded, but the file is read whole, and a PNG
/// refused whose end is missing or whose checksums are wrong. The same errors, except
/// E-IMAGE-TOOBIG.
[[nodiscard]] ImageSize read_image_size(const std::filesystem::path& path);

/// Lossless 8-bit PNG, the same bytes for the same pixels; written whole or not at all.
void write_png(const std::filesystem::path& path, const ColorImage& image);
void write_png(const std::filesystem::path& path, const GrayImage& image);
/// 16-bit grey PNG.
void write_png(const std::filesystem::path& path, const Image<std::uint16_t>& image);

[[nodiscard]] GrayImage read_gray_png(const std::filesystem::path& path);
[[nodiscard]] Image<std::uint16_t> read_gray16_png(const std::filesystem::path& path);

/// JPEG of the stated quality (1 to 100), without chroma subsampling.
void write_jpeg(const std::filesystem::path& path, const ColorImage& image, int quality);

/// 32-bit float, one channel: TIFF. Values are kept to the bit.
void write_float_tiff(const std::filesystem::path& path, const FloatImage& image);
[[nodiscard]] FloatImage read_float_tiff(const std::filesystem::path& path);

/// Area-averaging when smaller, bicubic when larger.
[[nodiscard]] ColorImage resized(const ColorImage& image, int width_px, int height_px);

}  // namespace lumi
