#include "tests/render/frame_difference.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace lumi {

ColorImage as_color(const GrayImage& gray) {
    ColorImage color(gray.width(), gray.height());
    for (int y = 0; y < gray.height(); ++y)
        for (int x = 0; x < gray.width(); ++x) color(x, y) = {gray(x, y), gray(x, y), gray(x, y)};
    return color;
}

FrameDifference difference_between(const ColorImage& a, const ColorImage& b) {
    assert(a.width() == b.width() && a.height() == b.height());
    FrameDifference difference;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) {
        const Rgb8& p = a.pixels()[i];
        const Rgb8& q = b.pixels()[i];
        const int red = std::abs(p.r - q.r);
        const int green = std::abs(p.g - q.g);
        const int blue = std::abs(p.b - q.b);
        const int largest = std::max({red, green, blue});
        difference.mean += (red + green + blue) / 3.0;
        difference.share_beyond_two += largest > 2 ? 1 : 0;
        difference.largest = std::max(difference.largest, largest);
    }
    const auto count = static_cast<double>(a.pixels().size());
    difference.mean /= count;
    difference.share_beyond_two /= count;
    return difference;
}

}  // namespace lumi
