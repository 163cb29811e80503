#include "calib/pictures/lost_color.h"

#include <algorithm>
#include <cmath>

namespace lumi {

bool has_color(const ColorImage& picture) {
    constexpr int kMostApart = 3;
    constexpr double kMostOfPixels = 0.005;
    const auto colored =
        std::count_if(picture.pixels().begin(), picture.pixels().end(), [](const Rgb8& pixel) {
            const auto [least, most] = std::minmax({pixel.r, pixel.g, pixel.b});
            return most - least > kMostApart;
        });
    return static_cast<double>(colored) >
           kMostOfPixels * static_cast<double>(picture.pixels().size());
}

ColorImage without_color(const ColorImage& picture) {
    ColorImage result = picture;
    for (Rgb8& pixel : result.pixels()) {
        const double luma = 0.299 * pixel.r + 0.587 * pixel.g + 0.114 * pixel.b;
        pixel.r = pixel.g = pixel.b = static_cast<std::uint8_t>(std::lround(luma));
    }
    return result;
}

}  // namespace lumi
