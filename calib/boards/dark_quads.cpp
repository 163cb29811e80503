#include "calib/boards/dark_quads.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "calib/boards/point_grid.h"
#include "calib/boards/quad_sides.h"
#include "calib/boards/shrunk_picture.h"
#include "calib/opencv/opencv_picture.h"

namespace lumi {
namespace {

using Outline = std::vector<cv::Point>;
using Corners = std::array<Eigen::Vector2d, 4>;

double side_px(const Corners& corners, std::size_t side) {
    return (corners[(side + 1) % 4] - corners[side]).norm();
}

double shortest_side_px(const Corners& corners) {
    double shortest = side_px(corners, 0);
    for (std::size_t side = 1; side < 4; ++side) {
        shortest = std::min(shortest, side_px(corners, side));
    }
    return shortest;
}

/// Where the diagonals meet: the image of the centre of a square under perspective.
Eigen::Vector2d diagonal_crossing(const Corners& corners) {
    const auto line = [&](std::size_t a, std::size_t b) {
        return corners[a].homogeneous().cross(corners[b].homogeneous());
    };
    return Eigen::Vector3d(line(0, 2).cross(line(1, 3))).hnormalized();
}

/// The four corners of an outline that is one, in our pixels; clockwise as seen.
std::optional<Corners> corners_of(const Outline& outline) {
    const double length_px = cv::arcLength(outline, true);
    const double area_px2 = cv::contourArea(outline);
    constexpr double kLeastArea_px2 = 30;
    constexpr double kLeastRoundness = 0.02;  // Of area to squared length; a square has 0.0625.
    if (area_px2 < kLeastArea_px2 || area_px2 < kLeastRoundness * length_px * length_px) {
        return std::nullopt;
    }
    for (const double share : {0.03, 0.05, 0.08}) {
        Outline simple;
        cv::approxPolyDP(outline, simple, share * length_px, true);
        if (simple.size() != 4 || !cv::isContourConvex(simple)) continue;
        // A disc has an inscribed square, too, but a larger area.
        const double filled = area_px2 / cv::contourArea(simple);
        if (filled < 0.8 || filled > 1.2) continue;
        if (cv::contourArea(simple, true) < 0) std::reverse(simple.begin(), simple.end());
        Corners corners;
        for (std::size_t corner = 0; corner < 4; ++corner) {
            corners[corner] = from_opencv(cv::Point2f(simple[corner]));
        }
        return corners;
    }
    return std::nullopt;
}

double value_at(const GrayImage& picture, const Eigen::Vector2d& px) {
    const int x = std::clamp(static_cast<int>(std::floor(px.x())), 0, picture.width() - 1);
    const int y = std::clamp(static_cast<int>(std::floor(px.y())), 0, picture.height() - 1);
    return picture(x, y);
}

/// The ground just outside the middle of each side, minus the shape just inside: the least.
double contrast_of(const GrayImage& picture, const Corners& corners) {
    const Eigen::Vector2d centre = diagonal_crossing(corners);
    double least = 255;
    for (std::size_t side = 0; side < 4; ++side) {
        double outside = 0;
        double inside = 0;
        for (const double along : {0.35, 0.5, 0.65}) {
            const Eigen::Vector2d middle =
                (1 - along) * corners[side] + along * corners[(side + 1) % 4];
            const Eigen::Vector2d outwards = middle - centre;
            const double reach = std::max(0.12, 2.0 / std::max(outwards.norm(), 1.0));
            outside += value_at(picture, middle + reach * outwards) / 3;
            inside += value_at(picture, middle - reach * outwards) / 3;
        }
        least = std::min(least, outside - inside);
    }
    return least;
}

/// Outlines of what is darker than its neighbourhood.
void add_quads(const GrayImage& picture, const cv::Mat& dark, std::vector<Corners>& quads) {
    std::vector<Outline> outlines;
    cv::findContours(dark, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
    for (const Outline& outline : outlines) {
        const auto corners = corners_of(outline);
        constexpr double kLeastContrast = 12;
        if (corners && contrast_of(picture, *corners) >= kLeastContrast) quads.push_back(*corners);
    }
}

/// For shapes too small or too faint to have sides.
Corners refined_one_by_one(const GrayImage& picture, const Corners& corners) {
    constexpr double kWindowShare = 0.12;
    const int half_window_px =
        std::clamp(static_cast<int>(std::lround(kWindowShare * shortest_side_px(corners))), 2, 10);
    std::vector<cv::Point2f> points;
    for (const Eigen::Vector2d& corner : corners) points.push_back(to_opencv(corner));
    cv::cornerSubPix(opencv_view(picture), points, {half_window_px, half_window_px}, {-1, -1},
                     {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 40, 1e-3});
    Corners result;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        // Where there is no corner to be found, the refinement wanders off.
        const Eigen::Vector2d moved = from_opencv(points[corner]);
        const bool has_stayed = (moved - corners[corner]).norm() <= 1.5 * half_window_px;
        result[corner] = has_stayed ? moved : corners[corner];
    }
    return result;
}

Corners refined(const GrayImage& picture, const Corners& corners) {
    const auto met = corners_where_sides_meet(picture, corners);
    return met ? *met : refined_one_by_one(picture, corners);
}

/// The same shape comes from several thresholds: the first stays.
std::vector<Corners> without_repetitions(const std::vector<Corners>& quads) {
    std::vector<Eigen::Vector2d> centres;
    for (const Corners& corners : quads) centres.push_back(diagonal_crossing(corners));
    const PointGrid grid(centres);
    std::vector<bool> is_repeated(quads.size(), false);
    std::vector<Corners> kept;
    for (std::size_t index = 0; index < quads.size(); ++index) {
        if (is_repeated[index]) continue;
        kept.push_back(quads[index]);
        const double side = shortest_side_px(quads[index]);
        for (const std::size_t other : grid.within(centres[index], 0.3 * side)) {
            const double ratio = shortest_side_px(quads[other]) / side;
            if (ratio > 0.7 && ratio < 1.4) is_repeated[other] = true;
        }
    }
    return kept;
}

}  // namespace

std::vector<DarkQuad> detect_dark_quads(const GrayImage& picture) {
    const cv::Mat small = shrunk_picture(picture);
    GrayImage small_picture(small.cols, small.rows);
    small.copyTo(opencv_view(small_picture));

    std::vector<Corners> quads;
    const int shorter_px = std::min(small.cols, small.rows);
    for (const int part : {5, 14, 40}) {
        const int neighbourhood_px = std::max(11, shorter_px / part) | 1;
        cv::Mat dark;
        cv::adaptiveThreshold(small, dark, 255, cv::ADAPTIVE_THRESH_MEAN_C, cv::THRESH_BINARY_INV,
                              neighbourhood_px, 7);
        add_quads(small_picture, dark, quads);
        // Corners that touch part when the ground grows.
        cv::Mat parted;
        cv::erode(dark, parted, cv::Mat::ones(3, 3, CV_8U));
        add_quads(small_picture, parted, quads);
    }
    std::vector<DarkQuad> result;
    const Eigen::Vector2d size_ratio(static_cast<double>(picture.width()) / small.cols,
                                     static_cast<double>(picture.height()) / small.rows);
    for (Corners corners : without_repetitions(quads)) {
        corners = refined(small_picture, corners);
        for (Eigen::Vector2d& corner : corners) corner = corner.cwiseProduct(size_ratio);
        if (size_ratio != Eigen::Vector2d::Ones()) corners = refined(picture, corners);
        DarkQuad quad;
        quad.corners_px = corners;
        quad.centre_px = diagonal_crossing(corners);
        quad.side_px = shortest_side_px(corners);
        quad.contrast = contrast_of(picture, corners);
        if (quad.centre_px.allFinite() && quad.side_px > 3) result.push_back(quad);
    }
    return result;
}

}  // namespace lumi
