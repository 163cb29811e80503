#include "calib/ingest/black_corners.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <set>
#include <vector>

#include "calib/ingest/pixel_parts.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

bool is_black(const StandingPixels& standing, int x, int y) {
    constexpr double kBlackLevel = 16;
    return standing.mean(x, y) <= kBlackLevel && standing.spread(x, y) <= kStillSpread;
}

/// The parts that a corner pixel of the picture belongs to.
std::set<int> parts_at_corners(const PixelParts& parts) {
    const int right = parts.part_of.cols - 1;
    const int bottom = parts.part_of.rows - 1;
    std::set<int> found;
    for (const cv::Point corner : {cv::Point(0, 0), {right, 0}, {0, bottom}, {right, bottom}})
        found.insert(parts.part_of.at<int>(corner));
    found.erase(0);
    return found;
}

cv::Mat distances_px(const cv::Mat& pixels) {
    cv::Mat distances;
    cv::distanceTransform(pixels == 0, distances, cv::DIST_L2, cv::DIST_MASK_5);
    return distances;
}

/// Pixels that are equally far from some.
struct Ring {
    std::vector<double> levels;
    int edges = 0;  ///< Those that become brighter the same way in most photographs.
};

/// From a distance of up to one pixel on.
std::vector<Ring> rings_at(const cv::Mat& distances, int rings, const StandingPixels& standing,
                           const ImageRectangle& picture) {
    constexpr double kMost = 0.8;
    std::vector<Ring> around(static_cast<std::size_t>(rings));
    for (int y = 0; y < distances.rows; ++y) {
        for (int x = 0; x < distances.cols; ++x) {
            const auto distance_px = distances.at<float>(y, x);
            if (distance_px <= 0 || distance_px > static_cast<float>(rings)) continue;
            Ring& ring = around[static_cast<std::size_t>(std::ceil(distance_px)) - 1];
            ring.levels.push_back(standing.mean(picture.left + x, picture.top + y));
            if (standing.edge(picture.left + x, picture.top + y).same_slope_share >= kMost)
                ++ring.edges;
        }
    }
    return around;
}

/// How many rings brightness takes to recover, if it does along an edge.
std::optional<std::size_t> rings_until_bright(const std::vector<Ring>& rings) {
    constexpr std::size_t kAhead = 3;
    constexpr double kNoRise = 1.05;
    constexpr double kMostEdges = 0.5;
    double edges = 0;
    double pixels = 0;
    for (std::size_t ring = 0; ring + kAhead < rings.size(); ++ring) {
        edges += rings[ring].edges;
        pixels += static_cast<double>(rings[ring].levels.size());
        if (median_of(rings[ring + kAhead].levels) > kNoRise * median_of(rings[ring].levels))
            continue;
        if (edges < kMostEdges * pixels) return std::nullopt;
        return ring + 1;
    }
    return std::nullopt;
}

}  // namespace

cv::Mat black_corners(const StandingPixels& standing, const ImageRectangle& picture) {
    constexpr int kFewest_px = 24;
    const PixelParts black(
        pixels_where(picture, [&](int x, int y) { return is_black(standing, x, y); }));
    cv::Mat corners = cv::Mat::zeros(picture.height_px, picture.width_px, CV_8U);
    const int rings = std::min(picture.width_px, picture.height_px) / 6;
    for (const int part : parts_at_corners(black)) {
        if (black.area_px(part) < kFewest_px) continue;
        const cv::Mat distances = distances_px(black.part_of == part);
        const auto wide_px = rings_until_bright(rings_at(distances, rings, standing, picture));
        if (wide_px) corners |= distances <= static_cast<double>(*wide_px);
    }
    return corners;
}

}  // namespace lumi
