#include "calib/capture/gray.h"

#include <algorithm>

namespace lumi {

GrayImage gray_of(const ColorImage& image) {
    GrayImage result(image.width(), image.height());
    std::transform(image.pixels().begin(), image.pixels().end(), result.pixels().begin(),
                   [](const Rgb8& pixel) {
                       const double luma = 0.2126 * pixel.r + 0.7152 * pixel.g + 0.0722 * pixel.b;
                       return static_cast<std::uint8_t>(luma + 0.5);
                   });
    return result;
}

}  // namespace lumi
