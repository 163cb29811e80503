#include "calib/ingest/overlay.h"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "calib/ingest/backdrop.h"
#include "calib/ingest/black_corners.h"
#include "calib/ingest/pixel_parts.h"

namespace lumi {
namespace {

constexpr double kMovingSpread = 3 * kStillSpread;

bool is_clear(const SharedEdge& edge) {
    constexpr double kMinGradient = 6.0;
    return edge.mean_gradient >= kMinGradient;
}

/// Points the same way in nearly every photograph.
bool is_standing_edge(const StandingPixels& standing, int x, int y) {
    constexpr double kNearlyAll = 0.95;
    const SharedEdge edge = standing.edge_in_any_color(x, y);
    return is_clear(edge) && edge.same_slope_share >= kNearlyAll;
}

cv::Mat standing_edges(const StandingPixels& standing, const ImageRectangle& picture) {
    return pixels_where(picture, [&](int x, int y) { return is_standing_edge(standing, x, y); });
}

/// Edges that stand still in many photographs, and move in others. By luma alone: compression
/// smears colours beside what stands still.
cv::Mat nearly_standing_edges(const StandingPixels& standing, const ImageRectangle& picture) {
    constexpr double kMost = 0.8;
    return pixels_where(picture, [&](int x, int y) {
        const SharedEdge edge = standing.edge(x, y);
        return is_clear(edge) && edge.same_slope_share >= kMost &&
               !is_standing_edge(standing, x, y);
    });
}

/// Areas that stand still although nearly all around them changes.
cv::Mat standing_areas(const StandingPixels& standing, const ImageRectangle& picture) {
    constexpr double kMovingShare = 0.7;
    constexpr int kMinArea_px = 12;
    constexpr int kAround_px = 3;
    const cv::Mat moving =
        pixels_where(picture, [&](int x, int y) { return standing.spread(x, y) >= kMovingSpread; });
    const PixelParts still(
        pixels_where(picture, [&](int x, int y) { return standing.spread(x, y) <= kStillSpread; }));
    cv::Mat areas = cv::Mat::zeros(moving.size(), CV_8U);
    for (int part = 1; part < still.count; ++part) {
        if (still.area_px(part) < kMinArea_px) continue;
        const cv::Rect around = still.around(part, kAround_px);
        const cv::Mat own = still.part_of(around) == part;
        const cv::Mat ring = grown(own, kAround_px) & ~grown(own, kAround_px - 1);
        const int ring_px = cv::countNonZero(ring);
        const int moving_px = cv::countNonZero(ring & moving(around));
        if (ring_px > 0 && moving_px >= kMovingShare * ring_px) areas(around) |= own;
    }
    return areas;
}

/// Over the pixels that are not 0, within the rectangle.
double mean_spread(const StandingPixels& standing, const ImageRectangle& picture,
                   const cv::Mat& pixels) {
    double sum = 0;
    for (int y = 0; y < pixels.rows; ++y) {
        for (int x = 0; x < pixels.cols; ++x) {
            if (pixels.at<std::uint8_t>(y, x) != 0) {
                sum += standing.spread(picture.left + x, picture.top + y);
            }
        }
    }
    return sum / std::max(1, cv::countNonZero(pixels));
}

/// What lies within an outline and changes by less than half of what the picture does: through a
/// label some of the picture may show.
void fill_labels(const StandingPixels& standing, const ImageRectangle& picture, cv::Mat& over) {
    constexpr double kVeiled = 0.5;
    const cv::Mat beside = over == 0;
    const double spread = mean_spread(standing, picture, beside);
    const PixelParts parts(beside, 4);
    for (int part = 1; part < parts.count; ++part) {
        const cv::Rect box = parts.around(part, 0);
        const bool is_within = box.x > 0 && box.y > 0 && box.x + box.width < over.cols &&
                               box.y + box.height < over.rows;
        if (!is_within) continue;
        const cv::Mat own = parts.part_of(box) == part;
        const ImageRectangle within{picture.left + box.x, picture.top + box.y, box.width,
                                    box.height};
        if (mean_spread(standing, within, own) < kVeiled * spread) over(box) |= own;
    }
}

cv::Mat without_gaps(const cv::Mat& pixels) {
    constexpr int kGap_px = 4;  // Within letters, and between them.
    cv::Mat closed;
    cv::morphologyEx(pixels, closed, cv::MORPH_CLOSE,
                     cv::getStructuringElement(cv::MORPH_RECT, {2 * kGap_px + 1, 2 * kGap_px + 1}));
    return closed;
}

/// Leaves out crumbs, and what has many edges in and beside it that nearly stand still: there the
/// scene itself is far away along a straight rail, or what a camera on one turns about.
cv::Mat without_scene(const cv::Mat& over, const cv::Mat& edges, const cv::Mat& nearly_standing) {
    constexpr int kMinCrumb_px = 24;
    constexpr int kBeside_px = 12;
    constexpr double kMostNearly = 0.25;
    cv::Mat kept = cv::Mat::zeros(over.size(), CV_8U);
    const PixelParts parts(over);
    for (int part = 1; part < parts.count; ++part) {
        if (parts.area_px(part) < kMinCrumb_px) continue;
        const cv::Rect around = parts.around(part, kBeside_px);
        const cv::Mat own = parts.part_of(around) == part;
        const int nearly = cv::countNonZero(grown(own, kBeside_px) & nearly_standing(around));
        const double outline_px = 4 * std::sqrt(parts.area_px(part));
        const double still_px = std::max(outline_px, 1.0 * cv::countNonZero(own & edges(around)));
        if (nearly <= kMostNearly * still_px) kept(around) |= own;
    }
    return kept;
}

}  // namespace

Overlay overlay_of(const StandingPixels& standing, int min_side_px) {
    constexpr double kLeastShare = 0.0025;
    constexpr double kMostShare = 0.2;
    constexpr int kMargin_px = 4;
    Overlay overlay{{0, 0, standing.width(), standing.height()}, {}, 0.0};
    if (standing.photographs() < kFewestForOverlay) return overlay;
    overlay.picture = picture_between_bars(standing, min_side_px);
    if (backdrop_levels(standing, overlay.picture)) return overlay;
    const cv::Mat edges = standing_edges(standing, overlay.picture);
    cv::Mat over = without_scene(without_gaps(edges | standing_areas(standing, overlay.picture)),
                                 edges, nearly_standing_edges(standing, overlay.picture));
    over |= black_corners(standing, overlay.picture);
    fill_labels(standing, overlay.picture, over);
    over = grown(over, kMargin_px);
    const double share =
        static_cast<double>(cv::countNonZero(over)) / static_cast<double>(over.total());
    if (share < kLeastShare || share > kMostShare) return overlay;
    overlay.share = share;
    overlay.mask = GrayImage(over.cols, over.rows, 255);
    for (int y = 0; y < over.rows; ++y) {
        for (int x = 0; x < over.cols; ++x) {
            if (over.at<std::uint8_t>(y, x) != 0) overlay.mask(x, y) = 0;
        }
    }
    return overlay;
}

}  // namespace lumi
