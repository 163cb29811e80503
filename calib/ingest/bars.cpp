#include "calib/ingest/bars.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

#include "calib/work/median.h"

namespace lumi {
namespace {

/// One row or column.
struct Line {
    double still_share = 0;  ///< Of its pixels.
    double slope_share = 0;  ///< Mean of same_slope_share.
    double plain_share = 0;  ///< Of its pixels, those of the line's median level.

    /// A bar may have a date or a title in it.
    [[nodiscard]] bool is_of_bar() const {
        constexpr double kStill = 0.97;
        constexpr double kPlain = 0.8;
        return still_share >= kStill && plain_share >= kPlain;
    }
};

/// Share of the levels that differ from their median by no more than compression makes them.
double share_of_median_level(std::vector<double> levels) {
    const double median = median_of(levels);
    const auto alike = std::count_if(levels.begin(), levels.end(), [&](double level) {
        return std::abs(level - median) <= kStillSpread;
    });
    return static_cast<double>(alike) / static_cast<double>(levels.size());
}

/// How many lines from the first on are still and of one colour, if they end sharply and in all
/// photographs at the same place; 0 if they do not. Lines of the picture are as still as bars
/// across them make them.
int lines_of_bar(const std::vector<Line>& lines) {
    constexpr double kPicture = 0.2;
    constexpr double kEdge = 0.5;
    constexpr std::ptrdiff_t kSharpEnd_px = 3;
    constexpr int kBlurred_px = 2;
    double least = 1.0;
    for (const Line& line : lines) least = std::min(least, line.still_share);
    const double most_of_picture = least + kPicture * (1 - least);
    const auto end = std::find_if_not(lines.begin(), lines.end(),
                                      [](const Line& line) { return line.is_of_bar(); });
    if (end == lines.begin()) return 0;
    const auto sharp = end + std::min(kSharpEnd_px, lines.end() - end);
    const auto picture = std::find_if(
        end, sharp, [&](const Line& line) { return line.still_share <= most_of_picture; });
    const bool is_edge = std::any_of(
        end - 1, sharp, [&](const Line& line) { return line.slope_share >= kEdge * (1 - least); });
    if (picture == sharp || !is_edge) return 0;
    // Where the bar ends the picture may be blurred with it.
    return static_cast<int>(picture - lines.begin()) + kBlurred_px;
}

struct Margins {
    int before = 0;
    int after = 0;

    [[nodiscard]] int sum() const { return before + after; }
    [[nodiscard]] bool is_even(int side_px) const {
        constexpr double kMostOff = 0.03;
        return std::abs(before - after) <= kMostOff * side_px;
    }
};

Margins bars_of(std::vector<Line> lines) {
    const int before = lines_of_bar(lines);
    std::reverse(lines.begin(), lines.end());
    return {before, lines_of_bar(lines)};
}

/// `count` lines of `length` pixels.
template <typename PixelOfLine>
std::vector<Line> lines_of(const StandingPixels& standing, int count, int length,
                           const PixelOfLine& pixel) {
    std::vector<Line> lines(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        Line& line = lines[static_cast<std::size_t>(i)];
        std::vector<double> levels;
        for (int k = 0; k < length; ++k) {
            const auto [x, y] = pixel(i, k);
            if (standing.spread(x, y) <= kStillSpread) line.still_share += 1.0 / length;
            line.slope_share += standing.same_slope_share(x, y) / length;
            levels.push_back(standing.mean(x, y));
        }
        line.plain_share = share_of_median_level(std::move(levels));
    }
    return lines;
}

}  // namespace

ImageRectangle picture_between_bars(const StandingPixels& standing, int min_side_px) {
    const int width = standing.width();
    const int height = standing.height();
    const ImageRectangle whole{0, 0, width, height};
    const Margins rows = bars_of(lines_of(standing, height, width, [](int i, int k) {
        return std::pair{k, i};
    }));
    const int rows_left = height - rows.before - rows.after;
    if (rows_left < std::max(height / 4, min_side_px)) return whole;
    const Margins columns = bars_of(lines_of(standing, width, rows_left, [&](int i, int k) {
        return std::pair{i, rows.before + k};
    }));
    const int columns_left = width - columns.before - columns.after;
    if (columns_left < std::max(width / 4, min_side_px)) return whole;
    const bool is_framed = rows.sum() > 0 && columns.sum() > 0;
    if (is_framed && !(rows.is_even(height) && columns.is_even(width))) return whole;
    return {columns.before, rows.before, columns_left, rows_left};
}

}  // namespace lumi
