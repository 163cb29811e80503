#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "calib/pictures/stored_picture.h"

namespace lumi {

/// What a JPEG says of its colours: the ICC profile of its APP2 segments (ICC.1, annex B.4), or
/// Adobe RGB by EXIF alone, as cameras mark it (DCF: uncalibrated, interoperability index R03).
[[nodiscard]] ColorTags jpeg_color_tags(std::span<const std::uint8_t> bytes);

/// What a PNG, as check_png accepts it, says of its colours: the code points of its cICP chunk,
/// else the profile of its iCCP chunk, or a gAMA chunk that says linear.
[[nodiscard]] ColorTags png_color_tags(std::span<const std::uint8_t> bytes);

/// Throws Error (E-IMAGE-FORMAT) where colours are coded for HDR by PQ: what they look like on an
/// ordinary screen is a matter of taste.
void refuse_pq(const ColorTags& tags, const std::filesystem::path& path);

}  // namespace lumi
