#include "calib/boards/disc_centres.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "calib/boards/point_grid.h"
#include "calib/boards/shrunk_picture.h"
#include "calib/opencv/opencv_picture.h"

namespace lumi {
namespace {

using Outline = std::vector<cv::Point>;

/// The ellipse that has an outline's moments, when the outline follows it.
std::optional<DiscImage> ellipse_of(const Outline& outline) {
    const cv::Moments moments = cv::moments(outline);
    constexpr double kLeastArea_px2 = 12;
    if (moments.m00 < kLeastArea_px2) return std::nullopt;
    DiscImage disc;
    disc.area_px2 = moments.m00;
    disc.centre_px = from_opencv({static_cast<float>(moments.m10 / moments.m00),
                                  static_cast<float>(moments.m01 / moments.m00)});
    disc.moments_px2 << moments.mu20, moments.mu11, moments.mu11, moments.mu02;
    disc.moments_px2 /= moments.m00;
    const double determinant = disc.moments_px2.determinant();
    if (!(determinant > 0)) return std::nullopt;
    // An ellipse has area 4 pi sqrt(det); a square 5 % less, a cross or a letter far less.
    const double filled = disc.area_px2 / (4 * std::numbers::pi * std::sqrt(determinant));
    const double tolerance = 0.03 + 0.5 / std::sqrt(disc.area_px2);
    if (std::abs(filled - 1) > tolerance) return std::nullopt;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(disc.moments_px2);
    constexpr double kMaxAxisRatio = 6.0;
    if (axes.eigenvalues()(1) > kMaxAxisRatio * kMaxAxisRatio * axes.eigenvalues()(0)) {
        return std::nullopt;
    }
    // Every point of the outline lies near the ellipse (its radius is 2 in units of the moments).
    const Eigen::Matrix2d inverse = disc.moments_px2.inverse();
    const double least_axis_px = 2 * std::sqrt(axes.eigenvalues()(0));
    const double allowed = 0.12 + 1.0 / least_axis_px;
    for (const cv::Point& point : outline) {
        const Eigen::Vector2d offset = from_opencv(cv::Point2f(point)) - disc.centre_px;
        const double radius = 0.5 * std::sqrt(offset.dot(inverse * offset));
        if (std::abs(radius - 1) > allowed) return std::nullopt;
    }
    return disc;
}

/// Mean grey value on the ellipse scaled by `factor`; -1 when it leaves the picture.
double mean_on_ellipse(const GrayImage& picture, const DiscImage& disc, double factor,
                       double& spread) {
    const Eigen::Matrix2d root = Eigen::LLT<Eigen::Matrix2d>(disc.moments_px2).matrixL();
    constexpr int kSamples = 24;
    double sum = 0;
    double squares = 0;
    for (int sample = 0; sample < kSamples; ++sample) {
        const double angle = 2 * std::numbers::pi * sample / kSamples;
        const Eigen::Vector2d px =
            disc.centre_px +
            factor * 2 * (root * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
        const int x = static_cast<int>(std::floor(px.x()));
        const int y = static_cast<int>(std::floor(px.y()));
        if (!picture.contains(x, y)) return -1;
        sum += picture(x, y);
        squares += static_cast<double>(picture(x, y)) * picture(x, y);
    }
    const double mean = sum / kSamples;
    spread = std::sqrt(std::max(0.0, squares / kSamples - mean * mean));
    return mean;
}

/// Measures centroid and moments again from grey values. False when there is no even ground.
bool refine(const GrayImage& picture, DiscImage& disc) {
    const double least_axis_px =
        2 * std::sqrt(
                Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(disc.moments_px2).eigenvalues()(0));
    const double reach = 1 + std::clamp(2.5 / least_axis_px, 0.15, 0.6);
    double inner_spread = 0;
    double outer_spread = 0;
    const double inner =
        mean_on_ellipse(picture, disc, std::max(0.0, 1 - 2.0 / least_axis_px), inner_spread);
    const double outer = mean_on_ellipse(picture, disc, reach, outer_spread);
    constexpr double kLeastContrast = 12;
    if (inner < 0 || outer < 0 || std::abs(outer - inner) < kLeastContrast) return false;
    disc.contrast = outer - inner;
    constexpr double kMaxSpreadShare = 0.35;
    if (outer_spread > kMaxSpreadShare * std::abs(disc.contrast)) return false;

    const Eigen::Matrix2d inverse = disc.moments_px2.inverse();
    const Eigen::Vector2d half_extent_px =
        2 * reach * disc.moments_px2.diagonal().cwiseSqrt() + Eigen::Vector2d::Ones();
    const Eigen::Vector2i first =
        (disc.centre_px - half_extent_px).array().floor().cast<int>().max(0).matrix();
    const Eigen::Vector2i last = (disc.centre_px + half_extent_px)
                                     .array()
                                     .ceil()
                                     .cast<int>()
                                     .min(Eigen::Array2i(picture.width(), picture.height()) - 1)
                                     .matrix();
    double weight_sum = 0;
    Eigen::Vector2d first_moments = Eigen::Vector2d::Zero();
    for (int y = first.y(); y <= last.y(); ++y) {
        for (int x = first.x(); x <= last.x(); ++x) {
            const Eigen::Vector2d px(x + 0.5, y + 0.5);
            const Eigen::Vector2d offset = px - disc.centre_px;
            if (0.5 * std::sqrt(offset.dot(inverse * offset)) > reach) continue;
            const double covered = std::clamp((outer - picture(x, y)) / (outer - inner), 0.0, 1.0);
            weight_sum += covered;
            first_moments += covered * offset;
        }
    }
    if (weight_sum <= 0) return false;
    const Eigen::Vector2d moved_px = first_moments / weight_sum;
    if (moved_px.norm() > 0.25 * least_axis_px + 0.5) return false;
    disc.centre_px += moved_px;
    disc.moments_px2 *= weight_sum / disc.area_px2;
    disc.area_px2 = weight_sum;
    return true;
}

std::vector<DiscImage> without_repetitions(const std::vector<DiscImage>& discs) {
    std::vector<Eigen::Vector2d> centres;
    for (const DiscImage& disc : discs) centres.push_back(disc.centre_px);
    const PointGrid grid(centres);
    std::vector<bool> is_repeated(discs.size(), false);
    std::vector<DiscImage> kept;
    for (std::size_t index = 0; index < discs.size(); ++index) {
        if (is_repeated[index]) continue;
        kept.push_back(discs[index]);
        const double radius_px = std::sqrt(discs[index].area_px2 / std::numbers::pi);
        for (const std::size_t other : grid.within(centres[index], 0.5 * radius_px)) {
            is_repeated[other] = true;
        }
    }
    return kept;
}

}  // namespace

std::vector<DiscImage> detect_discs(const GrayImage& picture) {
    const cv::Mat small = shrunk_picture(picture);
    const Eigen::Vector2d size_ratio(static_cast<double>(picture.width()) / small.cols,
                                     static_cast<double>(picture.height()) / small.rows);

    std::vector<DiscImage> discs;
    const int shorter_px = std::min(small.cols, small.rows);
    for (const int part : {5, 14, 40}) {
        const int neighbourhood_px = std::max(11, shorter_px / part) | 1;
        for (const int type : {cv::THRESH_BINARY_INV, cv::THRESH_BINARY}) {
            cv::Mat shapes;
            cv::adaptiveThreshold(small, shapes, 255, cv::ADAPTIVE_THRESH_MEAN_C, type,
                                  neighbourhood_px, type == cv::THRESH_BINARY_INV ? 7 : -7);
            std::vector<Outline> outlines;
            cv::findContours(shapes, outlines, cv::RETR_LIST, cv::CHAIN_APPROX_NONE);
            for (const Outline& outline : outlines) {
                auto disc = ellipse_of(outline);
                if (!disc) continue;
                disc->centre_px = disc->centre_px.cwiseProduct(size_ratio);
                disc->moments_px2 =
                    size_ratio.asDiagonal() * disc->moments_px2 * size_ratio.asDiagonal();
                disc->area_px2 *= size_ratio.prod();
                if (refine(picture, *disc)) discs.push_back(*disc);
            }
        }
    }
    return without_repetitions(discs);
}

}  // namespace lumi
