#include "tests/render/frame_difference.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace lumi {

namespace {

int largest_of_channels(const Rgb8& a, const Rgb8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Of the pixels around (x, y).
int least_difference_around(const ColorImage& a, const ColorImage& b, int x, int y) {
    int least = 255;
    for (int row = y - 1; row <= y + 1; ++row) {
        for (int column = x - 1; column <= x + 1; ++column)
            least = std::min(least, largest_of_channels(a(column, row), b(column, row)));
    }
    return least;
}

}  // namespace

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
        const int largest = largest_of_channels(p, q);
        difference.mean += (std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b)) / 3.0;
        difference.share_beyond_two += largest > 2 ? 1 : 0;
        difference.largest = std::max(difference.largest, largest);
    }
    const auto count = static_cast<double>(a.pixels().size());
    difference.mean /= count;
    difference.share_beyond_two /= count;
    for (int y = 1; y + 1 < a.height(); ++y) {
        for (int x = 1; x + 1 < a.width(); ++x)
            difference.largest_of_patches =
                std::max(difference.largest_of_patches, least_difference_around(a, b, x, y));
    }
    return difference;
}

}  // namespace lumi
