#include "calib/ingest/own_bars.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "calib/capture/gray.h"

namespace lumi {
namespace {

enum class BarColor { kBlack, kWhite };

bool has_color(std::uint8_t luma, BarColor color) {
    constexpr std::uint8_t kBlackest = 16;
    constexpr std::uint8_t kWhitest = 235;
    return color == BarColor::kBlack ? luma <= kBlackest : luma >= kWhitest;
}

/// How many lines from the first on are of that colour, with those where it is blurred with the
/// picture; 0 where no bar ends there. `share(line)`: how much of a line has the colour.
template <typename Share>
int lines_of_bar(int lines, const Share& share) {
    constexpr double kNearlyAll = 0.97;
    constexpr double kFewInPicture = 0.5;
    constexpr int kSharpEnd_px = 3;
    constexpr int kBlurredEnd_px = 2;
    int end = 0;
    while (end < lines && share(end) >= kNearlyAll) ++end;
    if (end == 0) return 0;
    for (int line = end; line < std::min(lines, end + kSharpEnd_px); ++line) {
        if (share(line) <= kFewInPicture) return line + kBlurredEnd_px;
    }
    return 0;
}

struct OwnBars {
    int before = 0;
    int after = 0;
};

/// Of lines of so many pixels; none unless there are two. `luma(line, k)`: of its pixel k.
template <typename Luma>
OwnBars own_bars(int lines, int pixels, const Luma& luma) {
    constexpr double kMostOff = 0.01;
    constexpr double kMostShare = 0.5;
    for (const BarColor color : {BarColor::kBlack, BarColor::kWhite}) {
        const auto share = [&](int line) {
            int of_color = 0;
            for (int k = 0; k < pixels; ++k) of_color += has_color(luma(line, k), color) ? 1 : 0;
            return static_cast<double>(of_color) / pixels;
        };
        const OwnBars bars{lines_of_bar(lines, share),
                           lines_of_bar(lines, [&](int line) { return share(lines - 1 - line); })};
        const double most_off_px = std::max(1.0, kMostOff * lines);
        if (bars.before > 0 && bars.after > 0 &&
            std::abs(bars.before - bars.after) <= most_off_px &&
            bars.before + bars.after < kMostShare * lines) {
            return bars;
        }
    }
    return {};
}

}  // namespace

ImageRectangle picture_between_own_bars(const ColorImage& photograph) {
    const GrayImage gray = gray_of(photograph);
    const int width = gray.width();
    const int height = gray.height();
    const OwnBars rows = own_bars(height, width, [&](int y, int x) { return gray(x, y); });
    if (rows.before > 0) return {0, rows.before, width, height - rows.before - rows.after};
    const OwnBars columns = own_bars(width, height, [&](int x, int y) { return gray(x, y); });
    return {columns.before, 0, width - columns.before - columns.after, height};
}

}  // namespace lumi
