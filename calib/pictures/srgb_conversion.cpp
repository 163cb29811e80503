#include "calib/pictures/srgb_conversion.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "calib/pictures/color_profile.h"

namespace lumi {
namespace {

ColorImage rounded(ColorImage picture) { return picture; }

ColorImage rounded(const Image<Rgb16>& picture) {
    ColorImage result(picture.width(), picture.height());
    constexpr int k16BitsOf8 = 257;
    const auto byte = [](std::uint16_t value) {
        return static_cast<std::uint8_t>((value + k16BitsOf8 / 2) / k16BitsOf8);
    };
    std::transform(picture.pixels().begin(), picture.pixels().end(), result.pixels().begin(),
                   [&](const Rgb16& pixel) -> Rgb8 {
                       return {byte(pixel.r), byte(pixel.g), byte(pixel.b)};
                   });
    return result;
}

/// Stored inverted, ideal inks multiply.
ColorImage rounded(const Image<InvertedCmyk8>& picture) {
    ColorImage result(picture.width(), picture.height());
    const auto product = [](int a, int b) {
        return static_cast<std::uint8_t>((a * b + 127) / 255);
    };
    std::transform(picture.pixels().begin(), picture.pixels().end(), result.pixels().begin(),
                   [&](const InvertedCmyk8& ink) -> Rgb8 {
                       return {product(ink.c, ink.k), product(ink.m, ink.k), product(ink.y, ink.k)};
                   });
    return result;
}

bool is_cmyk(const StoredPicture& stored) {
    return std::holds_alternative<Image<InvertedCmyk8>>(stored.raster);
}

/// Many grey pictures carry the profile of the program's RGB.
bool is_for(const ColorProfile& profile, const StoredPicture& stored) {
    switch (profile.numbers()) {
        case ColorProfile::Numbers::kRgb:
            return !is_cmyk(stored);
        case ColorProfile::Numbers::kGrey:
            return stored.is_grey;
        case ColorProfile::Numbers::kCmyk:
            return is_cmyk(stored);
    }
    return false;
}

/// Null: as sRGB.
std::shared_ptr<const ColorProfile> profile_of(const StoredPicture& stored,
                                               ColorConversion& conversion) {
    if (stored.tags.icc_profile) {
        auto embedded = ColorProfile::of(*stored.tags.icc_profile);
        if (embedded && is_for(*embedded, stored)) return embedded;
        conversion.profile_fault = embedded ? "is for pictures of another kind" : "is damaged";
    } else if (is_cmyk(stored)) {
        conversion.from = "CMYK without a profile";
    } else if (stored.tags.coded) {
        auto coded = ColorProfile::of(*stored.tags.coded);
        if (!coded) conversion.profile_fault = "names primaries or a curve that lumi does not know";
        return coded;
    } else if (stored.tags.is_linear) {
        return ColorProfile::linear_light();
    } else if (stored.tags.is_adobe_rgb) {
        return ColorProfile::adobe_rgb();
    }
    return nullptr;
}

double black_share(const GrayImage& mask) {
    const auto& pixels = mask.pixels();
    return static_cast<double>(std::count(pixels.begin(), pixels.end(), 0)) /
           static_cast<double>(std::max<std::size_t>(1, pixels.size()));
}

}  // namespace

SrgbPicture srgb_of(StoredPicture stored) {
    SrgbPicture result;
    ColorConversion& conversion = result.conversion;
    conversion.clipped_share = stored.clipped_share;
    result.shown = std::move(stored.shown);
    conversion.hidden_share = black_share(result.shown);
    const std::shared_ptr<const ColorProfile> profile = profile_of(stored, conversion);
    const bool converts = profile && !profile->is_srgb();
    if (converts) conversion.from = profile->name();
    result.picture = std::visit(
        [&](auto&& raster) {
            return converts ? profile->srgb_of(std::move(raster)) : rounded(std::move(raster));
        },
        std::move(stored.raster));
    return result;
}

}  // namespace lumi
