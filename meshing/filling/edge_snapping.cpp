#include "meshing/filling/edge_snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "meshing/exposure/color_match.h"
#include "meshing/matching/similarity_by_difference.h"

namespace lumi {
namespace {

constexpr int kBand = 3;    // Pixels on either side of a jump that are asked.
constexpr int kWindow = 7;  // Half a side of what they ask, less the pixel itself.
constexpr float kJumpPx = 3.0F;

/// Nearest and farthest inverse depth around each pixel.
struct Extremes {
    FloatImage nearest;
    FloatImage farthest;
};

/// 255 in the band along jumps between neighbouring pixels: a steep floor has none.
GrayImage band_of_jumps(const FloatImage& inverse_depth, float jump) {
    GrayImage band(inverse_depth.width(), inverse_depth.height());
    const auto mark = [&](int x, int y, int other_x, int other_y) {
        if (!band.contains(other_x, other_y)) return;
        if (std::abs(inverse_depth(x, y) - inverse_depth(other_x, other_y)) <= jump) return;
        band(x, y) = band(other_x, other_y) = 255;
    };
    for (int y = 0; y < band.height(); ++y) {
        for (int x = 0; x < band.width(); ++x) {
            mark(x, y, x + 1, y);
            mark(x, y, x, y + 1);
        }
    }
    cv::Mat matrix(band.height(), band.width(), CV_8U, band.pixels().data());
    cv::dilate(matrix, matrix, cv::Mat::ones(2 * kBand - 1, 2 * kBand - 1, CV_8U));
    return band;
}

Extremes extremes_of(const FloatImage& inverse_depth) {
    Extremes extremes{inverse_depth, inverse_depth};
    const cv::Mat box = cv::Mat::ones(2 * kBand + 1, 2 * kBand + 1, CV_8U);
    const auto matrix = [&](FloatImage& image) {
        return cv::Mat(image.height(), image.width(), CV_32F, image.pixels().data());
    };
    cv::Mat nearest = matrix(extremes.nearest);
    cv::Mat farthest = matrix(extremes.farthest);
    cv::dilate(nearest, nearest, box);
    cv::erode(farthest, farthest, box);
    return extremes;
}

/// The part of the window around a pixel that lies in the picture.
struct Window {
    int left, right, top, bottom;  ///< All inclusive.
};

Window window_around(const DepthMap& map, int x, int y) {
    return {std::max(0, x - kWindow), std::min(map.confidence.width() - 1, x + kWindow),
            std::max(0, y - kWindow), std::min(map.confidence.height() - 1, y + kWindow)};
}

/// The pixel of the window nearest to (x, y) that lies on the wanted side of `middle`.
std::array<int, 2> nearest_beyond(const DepthMap& map, const Window& window, int x, int y,
                                  float middle, bool wants_nearer) {
    std::array<int, 2> found{x, y};
    int least_distance = 1 << 20;  // Squared.
    for (int row = window.top; row <= window.bottom; ++row) {
        for (int column = window.left; column <= window.right; ++column) {
            const int distance = (column - x) * (column - x) + (row - y) * (row - y);
            if (distance >= least_distance) continue;
            if ((map.inverse_depth(column, row) > middle) != wants_nearer) continue;
            least_distance = distance;
            found = {column, row};
        }
    }
    return found;
}

/// Where the pixel should take its depth from; empty when it is on the right surface.
std::optional<std::array<int, 2>> better_source(const DepthMap& map, const ColorImage& photograph,
                                                int x, int y, float middle) {
    constexpr double kSimilar = 10.0;  // 8-bit levels.
    static const std::array<float, 256> similarity = similarity_by_difference(kSimilar);
    const Window window = window_around(map, x, y);
    const Rgb8 own = photograph(x, y);
    std::array<float, 2> votes{};  // For the farther and the nearer surface.
    for (int row = window.top; row <= window.bottom; ++row) {
        const Rgb8* colors = photograph.row(row);
        const float* inverse_depths = map.inverse_depth.row(row);
        for (int column = window.left; column <= window.right; ++column) {
            if (column == x && row == y) continue;
            const int difference = largest_difference(own, colors[column]);
            votes[inverse_depths[column] > middle ? 1 : 0] +=
                similarity[static_cast<std::size_t>(difference)];
        }
    }
    // To stay is easier than to change: texture is no silhouette.
    constexpr float kClearly = 1.5F;
    const bool is_nearer = map.inverse_depth(x, y) > middle;
    if (votes[is_nearer ? 0 : 1] <= kClearly * votes[is_nearer ? 1 : 0]) return std::nullopt;
    return nearest_beyond(map, window, x, y, middle, !is_nearer);
}

}  // namespace

void snap_edges(DepthMap& map, const ColorImage& photograph, double one_pixel,
                const GrayImage& kept) {
    if (one_pixel <= 0) return;
    const float jump = kJumpPx * static_cast<float>(one_pixel);
    const GrayImage band = band_of_jumps(map.inverse_depth, jump);
    const Extremes extremes = extremes_of(map.inverse_depth);
    const DepthMap before = map;
    for (int y = 0; y < map.confidence.height(); ++y) {
        for (int x = 0; x < map.confidence.width(); ++x) {
            if (band(x, y) == 0 || (!kept.empty() && kept(x, y) != 0)) continue;
            const float nearest = extremes.nearest(x, y);
            const float farthest = extremes.farthest(x, y);
            const auto source =
                better_source(before, photograph, x, y, 0.5F * (nearest + farthest));
            if (!source) continue;
            map.inverse_depth(x, y) = before.inverse_depth((*source)[0], (*source)[1]);
            map.confidence(x, y) = before.confidence((*source)[0], (*source)[1]);
        }
    }
}

}  // namespace lumi
