#include "calib/ingest/bars.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "calib/ingest/backdrop.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr int kBlurred_px = 2;  ///< Where a bar ends the picture may be blurred with it.

/// One row or column.
struct Line {
    double still_share = 0;   ///< Of its pixels.
    double slope_share = 0;   ///< Mean of SharedEdge::same_slope_share.
    double median_level = 0;  ///< Of its pixels' means.
    double plain_share = 0;   ///< Of its pixels, those of this level.

    [[nodiscard]] bool is_still() const {
        constexpr double kStill = 0.97;
        return still_share >= kStill;
    }
};

/// Share of the levels that differ from this one by no more than compression makes them.
double share_of_level(const std::vector<double>& levels, double level_of_all) {
    const auto alike = std::count_if(levels.begin(), levels.end(), [&](double level) {
        return std::abs(level - level_of_all) <= kStillSpread;
    });
    return static_cast<double>(alike) / static_cast<double>(levels.size());
}

template <typename Figure>
double median_over(std::span<const Line> lines, const Figure& figure) {
    std::vector<double> figures;
    for (const Line& line : lines) figures.push_back(figure(line));
    return median_of(std::move(figures));
}

/// Whether most of their pixels have one level along the line. A bar may have a date or a caption
/// in it: its first and its last quarter tell.
bool are_plain(std::span<const Line> lines) {
    constexpr double kPlain = 0.8;
    constexpr std::size_t kFewest = 3;
    const std::size_t quarter = std::max(lines.size() / 4, std::min(lines.size(), kFewest));
    const auto plain_share = [](const Line& line) { return line.plain_share; };
    return median_over(lines.first(quarter), plain_share) >= kPlain &&
           median_over(lines.last(quarter), plain_share) >= kPlain;
}

/// Lines along one side of the raster; none where there is no bar.
struct Bar {
    int lines = 0;
    double level = 0;
};

/// How many lines from the first on are still and plain, if they end sharply and in all
/// photographs at the same place; none if they do not. Lines of the picture are as still as bars
/// across them make them.
Bar bar_of(const std::vector<Line>& lines) {
    constexpr double kPicture = 0.2;
    constexpr double kEdge = 0.5;
    constexpr std::ptrdiff_t kSharpEnd_px = 3;
    double least = 1.0;
    for (const Line& line : lines) least = std::min(least, line.still_share);
    const double most_of_picture = least + kPicture * (1 - least);
    const auto end = std::find_if_not(lines.begin(), lines.end(),
                                      [](const Line& line) { return line.is_still(); });
    const std::span<const Line> still(lines.begin(), end);
    if (still.empty() || !are_plain(still)) return {};
    const auto sharp = end + std::min(kSharpEnd_px, lines.end() - end);
    const auto picture = std::find_if(
        end, sharp, [&](const Line& line) { return line.still_share <= most_of_picture; });
    const bool is_edge = std::any_of(
        end - 1, sharp, [&](const Line& line) { return line.slope_share >= kEdge * (1 - least); });
    if (picture == sharp || !is_edge) return {};
    return {static_cast<int>(picture - lines.begin()) + kBlurred_px,
            median_over(still, [](const Line& line) { return line.median_level; })};
}

struct Margins {
    Bar before;
    Bar after;

    [[nodiscard]] int sum() const { return before.lines + after.lines; }
    [[nodiscard]] bool is_even(int side_px) const {
        constexpr double kMostOff = 0.03;
        return std::abs(before.lines - after.lines) <= kMostOff * side_px;
    }
};

Margins bars_of(std::vector<Line> lines) {
    const Bar before = bar_of(lines);
    std::reverse(lines.begin(), lines.end());
    return {before, bar_of(lines)};
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
            line.slope_share += standing.edge(x, y).same_slope_share / length;
            levels.push_back(standing.mean(x, y));
        }
        line.median_level = median_of(levels);
        line.plain_share = share_of_level(levels, line.median_level);
    }
    return lines;
}

/// Mean over a line of `length` pixels: how many photographs have an edge where the bar beside it
/// ends. `pixel` leads from the line (0) out of the picture (below 0) or into it.
template <typename PixelAcross>
double edge_share(const StandingPixels& standing, int length, const PixelAcross& pixel) {
    double sum = 0;
    for (int k = 0; k < length; ++k) {
        double most = 0;
        for (int across = -kBlurred_px - 1; across < kBlurred_px; ++across) {
            const auto [x, y] = pixel(across, k);
            most = std::max(most, standing.edge(x, y).same_slope_share);
        }
        sum += most;
    }
    return sum / length;
}

bool is_edged_all_around(const StandingPixels& standing, const ImageRectangle& picture) {
    constexpr double kEdged = 0.8;
    const int right = picture.left + picture.width_px - 1;
    const int bottom = picture.top + picture.height_px - 1;
    const auto at_row = [&](int row, int inwards) {
        return edge_share(standing, picture.width_px, [=](int across, int k) {
            return std::pair{picture.left + k, row + inwards * across};
        });
    };
    const auto at_column = [&](int column, int inwards) {
        return edge_share(standing, picture.height_px, [=](int across, int k) {
            return std::pair{column + inwards * across, picture.top + k};
        });
    };
    return std::min({at_row(picture.top, 1), at_row(bottom, -1), at_column(picture.left, 1),
                     at_column(right, -1)}) >= kEdged;
}

bool are_of_backdrop(const StandingPixels& standing, const Margins& rows, const Margins& columns,
                     const ImageRectangle& picture) {
    const std::array<Bar, 4> bars{rows.before, rows.after, columns.before, columns.after};
    const std::optional<LevelRange> backdrop = backdrop_levels(standing, picture);
    return backdrop && std::any_of(bars.begin(), bars.end(), [&](const Bar& bar) {
               return bar.lines > 0 && backdrop->contains(bar.level);
           });
}

/// Black or white on all four sides, and beginning sharply along the whole of each: that no
/// backdrop does, wherever the picture lies in it.
bool is_frame(const StandingPixels& standing, const Margins& rows, const Margins& columns,
              const ImageRectangle& picture) {
    constexpr double kBlack = 16;
    constexpr double kWhite = 235;
    const std::array<Bar, 4> bars{rows.before, rows.after, columns.before, columns.after};
    if (std::any_of(bars.begin(), bars.end(), [](const Bar& bar) { return bar.lines == 0; }))
        return false;
    const auto [darkest, brightest] =
        std::minmax({bars[0].level, bars[1].level, bars[2].level, bars[3].level});
    return brightest - darkest <= kStillSpread && (brightest <= kBlack || darkest >= kWhite) &&
           is_edged_all_around(standing, picture);
}

}  // namespace

ImageRectangle picture_between_bars(const StandingPixels& standing, int min_side_px) {
    const int width = standing.width();
    const int height = standing.height();
    const ImageRectangle whole{0, 0, width, height};
    const Margins rows = bars_of(lines_of(standing, height, width, [](int i, int k) {
        return std::pair{k, i};
    }));
    const int rows_left = height - rows.sum();
    if (rows_left < std::max(height / 4, min_side_px)) return whole;
    const Margins columns = bars_of(lines_of(standing, width, rows_left, [&](int i, int k) {
        return std::pair{i, rows.before.lines + k};
    }));
    const int columns_left = width - columns.sum();
    if (columns_left < std::max(width / 4, min_side_px)) return whole;
    const ImageRectangle picture{columns.before.lines, rows.before.lines, columns_left, rows_left};
    const bool is_enclosed = rows.sum() > 0 && columns.sum() > 0;
    const bool is_in_the_middle = rows.is_even(height) && columns.is_even(width);
    if (is_enclosed && !is_in_the_middle && !is_frame(standing, rows, columns, picture))
        return whole;
    return are_of_backdrop(standing, rows, columns, picture) ? whole : picture;
}

}  // namespace lumi
