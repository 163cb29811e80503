#include "render/viewer/difference_picture.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace lumi {
namespace {

std::uint8_t brightened_difference(std::uint8_t a, std::uint8_t b) {
    constexpr int kBrighter = 4;
    return static_cast<std::uint8_t>(std::min(255, kBrighter * std::abs(a - b)));
}

}  // namespace

ColorImage difference_picture(const ColorImage& drawn, const ColorImage& photograph) {
    assert(drawn.width() == photograph.width() && drawn.height() == photograph.height());
    ColorImage difference(drawn.width(), drawn.height());
    for (std::size_t i = 0; i < difference.pixels().size(); ++i) {
        const Rgb8& a = drawn.pixels()[i];
        const Rgb8& b = photograph.pixels()[i];
        difference.pixels()[i] = {brightened_difference(a.r, b.r), brightened_difference(a.g, b.g),
                                  brightened_difference(a.b, b.b)};
    }
    return difference;
}

}  // namespace lumi
