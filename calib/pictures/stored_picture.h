#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "calib/capture/image.h"
#include "calib/work/whole_file.h"

namespace lumi {

struct Rgb16 {
    std::uint16_t r = 0;
    std::uint16_t g = 0;
    std::uint16_t b = 0;
};

/// As Adobe stores inks: 255 is none.
struct InvertedCmyk8 {
    std::uint8_t c = 0;
    std::uint8_t m = 0;
    std::uint8_t y = 0;
    std::uint8_t k = 0;
};

/// Code points of ITU-T H.273 for the primaries and the curve of colours, as HEIF and AVIF carry
/// them, and PNG in its cICP chunk. As they are here: sRGB.
struct CodedColors {
    int primaries = 1;
    int transfer = 13;
};
inline constexpr int kPqTransfer = 16;   ///< SMPTE ST 2084.
inline constexpr int kHlgTransfer = 18;  ///< Of BT.2100.

/// What a file says that its numbers mean; nothing: sRGB.
struct ColorTags {
    std::optional<Bytes> icc_profile;  ///< As embedded, however damaged.
    std::optional<CodedColors> coded;  ///< Counts where there is no profile.
    bool is_adobe_rgb = false;         ///< By EXIF alone.
    bool is_linear = false;            ///< Light, by the primaries of sRGB.
};

/// A decoded picture whose numbers mean what its tags say. What had an alpha channel is seen
/// before black.
struct StoredPicture {
    std::variant<ColorImage, Image<Rgb16>, Image<InvertedCmyk8>> raster;
    bool is_grey = false;  ///< All three channels repeat the only one of the file.
    ColorTags tags;
    double clipped_share = 0.0;  ///< Of the pixels: brighter than what the raster can hold.
    GrayImage shown;             ///< 0 where it is wholly transparent, else 255; empty: nowhere.
};

}  // namespace lumi
