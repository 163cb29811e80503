#include "pipeline/evaluate/comparison_strip.h"

#include <algorithm>
#include <cstdlib>

#include "calib/work/error.h"
#include "pipeline/evaluate/paste.h"
#include "pipeline/stages/color_scale.h"

namespace lumi {
namespace {

constexpr int kGapPx = 4;
constexpr Rgb8 kBackground{255, 255, 255};

int largest_difference(const Rgb8& a, const Rgb8& b) {
    return std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
}

/// Diagonal stripes in greys that no error has.
Rgb8 hatching(int x, int y) { return (x + y) % 16 < 8 ? Rgb8{255, 255, 255} : Rgb8{200, 200, 200}; }

ColorImage error_picture(const ColorImage& photograph, const ColorImage& rendering,
                         const GrayImage& coverage, int full_scale) {
    ColorImage picture(photograph.width(), photograph.height());
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const int difference = largest_difference(photograph(x, y), rendering(x, y));
            picture(x, y) = coverage(x, y) == 0 ? hatching(x, y)
                                                : color_of_share(static_cast<float>(difference) /
                                                                 static_cast<float>(full_scale));
        }
    }
    return picture;
}

/// The scale from no error (left) to `full_scale` (right), with a notch at each quarter.
void draw_scale(ColorImage& canvas, int left, int width, int top) {
    const int quarter = std::max(1, width / 4);
    for (int y = top; y < canvas.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const bool is_notch = x % quarter == 0 && y < top + (canvas.height() - top) / 2;
            canvas(left + x, y) =
                is_notch ? kBackground
                         : color_of_share(static_cast<float>(x) / static_cast<float>(width));
        }
    }
}

/// The height of the scale below pictures of that height.
int scale_height(int picture_height) { return std::max(6, picture_height / 50); }

ColorImage cut_out(const ColorImage& strip, int left, int width, int height) {
    ColorImage picture(width, height);
    for (int y = 0; y < height; ++y) std::copy_n(strip.row(y) + left, width, picture.row(y));
    return picture;
}

}  // namespace

ColorImage comparison_strip(const ColorImage& photograph, const ColorImage& rendering,
                            const GrayImage& coverage, int full_scale) {
    const int width = photograph.width();
    ColorImage strip(3 * width + 2 * kGapPx,
                     photograph.height() + kGapPx + scale_height(photograph.height()), kBackground);
    paste(strip, photograph, 0);
    paste(strip, rendering, width + kGapPx);
    paste(strip, error_picture(photograph, rendering, coverage, full_scale), 2 * (width + kGapPx));
    draw_scale(strip, 2 * (width + kGapPx), width, photograph.height() + kGapPx);
    return strip;
}

ComparisonPanels panels_of(const ColorImage& strip) {
    const int width = (strip.width() - 2 * kGapPx) / 3;
    int height = strip.height();
    while (height > 0 && height + kGapPx + scale_height(height) > strip.height()) --height;
    if (width <= 0 || height <= 0 || 3 * width + 2 * kGapPx != strip.width()) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-SIZE", "a picture is no comparison strip",
                    "run `lumi evaluate` again");
    }
    return {cut_out(strip, 0, width, height), cut_out(strip, width + kGapPx, width, height),
            cut_out(strip, 2 * (width + kGapPx), width, height)};
}

}  // namespace lumi
