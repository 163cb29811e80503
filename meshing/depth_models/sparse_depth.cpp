#include "meshing/depth_models/sparse_depth.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "calib/work/median.h"
#include "meshing/depth_scene/point_triangulation.h"
#include "meshing/filling/guided_smoothing.h"
#include "meshing/geometry/triangle_pixels.h"

namespace lumi {
namespace {

/// Mean of the nearest points' inverse depths, weighted by inverse squared distance.
double nearest_mean(const std::vector<SparsePoint>& points, const Eigen::Vector2d& pixel) {
    constexpr std::size_t kNearest = 6;
    std::vector<std::pair<double, double>> by_distance;  // Squared distance, inverse depth.
    for (const SparsePoint& point : points) {
        by_distance.emplace_back((point.pixel - pixel).squaredNorm(), point.inverse_depth);
    }
    const std::size_t count = std::min(kNearest, by_distance.size());
    std::partial_sort(by_distance.begin(), by_distance.begin() + static_cast<std::ptrdiff_t>(count),
                      by_distance.end());
    double sum = 0;
    double weights = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double weight = 1.0 / (1.0 + by_distance[i].first);
        sum += weight * by_distance[i].second;
        weights += weight;
    }
    return sum / weights;
}

/// Points just outside the picture, all around it.
std::vector<SparsePoint> border_points(const std::vector<SparsePoint>& points,
                                       const Camera& camera) {
    constexpr int kPerSide = 8;
    std::vector<SparsePoint> border;
    const auto add = [&](double x_share, double y_share) {
        const Eigen::Vector2d pixel(x_share * (camera.width_px + 2) - 1,
                                    y_share * (camera.height_px + 2) - 1);
        border.push_back({pixel, nearest_mean(points, pixel)});
    };
    for (int i = 0; i < kPerSide; ++i) {
        const double share = static_cast<double>(i) / kPerSide;
        add(share, 0);
        add(1, share);
        add(1 - share, 1);
        add(0, 1 - share);
    }
    return border;
}

GrayImage nearness(const std::vector<SparsePoint>& points, int width, int height) {
    constexpr double kReachShare = 0.02;  // Of the width.
    cv::Mat elsewhere(height, width, CV_8U, cv::Scalar(1));
    for (const SparsePoint& point : points) {
        elsewhere.at<std::uint8_t>(static_cast<int>(point.pixel.y()),
                                   static_cast<int>(point.pixel.x())) = 0;
    }
    cv::Mat distance;
    cv::distanceTransform(elsewhere, distance, cv::DIST_L2, cv::DIST_MASK_PRECISE);
    GrayImage confidence(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double reaches =
                static_cast<double>(distance.at<float>(y, x)) / (kReachShare * width);
            confidence(x, y) =
                static_cast<std::uint8_t>(kMostByPoints * std::exp(-0.5 * reaches * reaches));
        }
    }
    return confidence;
}

/// Points that agree with their surroundings. Two pixels of parallax are no outlier, however smooth
/// the rest is.
std::vector<SparsePoint> reliable_points(const DepthView& view) {
    return without_outliers(view.points, view.disparity_px_per_inverse_depth > 0
                                             ? 2.0 / view.disparity_px_per_inverse_depth
                                             : 0.0);
}

}  // namespace

std::vector<char> agree_with_surroundings(const std::vector<SparsePoint>& points,
                                          double smallest_difference) {
    constexpr std::size_t kMinPoints = 8;
    std::vector<char> agree(points.size(), 1);
    if (points.size() < kMinPoints) return agree;
    const PointTriangulation triangulation = triangulate(points);
    std::vector<double> residuals(points.size(), 0.0);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::vector<double> ring;
        for (const int j : triangulation.rings[i]) {
            ring.push_back(points[static_cast<std::size_t>(j)].inverse_depth);
        }
        if (!ring.empty()) residuals[i] = std::abs(points[i].inverse_depth - median_of(ring));
    }
    const double limit =
        std::max(3 * kSigmaPerMedianOff * median_of(residuals), smallest_difference);
    for (std::size_t i = 0; i < points.size(); ++i) agree[i] = residuals[i] <= limit ? 1 : 0;
    return agree;
}

std::vector<SparsePoint> without_outliers(const std::vector<SparsePoint>& points,
                                          double smallest_difference) {
    const std::vector<char> agree = agree_with_surroundings(points, smallest_difference);
    std::vector<SparsePoint> kept;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (agree[i] != 0) kept.push_back(points[i]);
    }
    return kept;
}

DepthMap sparse_depth(const DepthView& view) {
    const int width = view.camera.width_px;
    const int height = view.camera.height_px;
    if (view.points.empty()) {
        const double middle = 0.5 * (view.range.far + view.range.near);
        return {FloatImage(width, height, static_cast<float>(middle)), GrayImage(width, height)};
    }
    std::vector<SparsePoint> points = reliable_points(view);
    DepthMap map{FloatImage(width, height), nearness(points, width, height)};
    const std::vector<SparsePoint> border = border_points(points, view.camera);
    points.insert(points.end(), border.begin(), border.end());
    for (const auto& [a, b, c] : triangulate(points).triangles) {
        for_each_pixel_in_triangle(points[static_cast<std::size_t>(a)],
                                   points[static_cast<std::size_t>(b)],
                                   points[static_cast<std::size_t>(c)], width, height,
                                   [&map](int x, int y, double inverse_depth) {
                                       map.inverse_depth(x, y) = static_cast<float>(inverse_depth);
                                   });
    }
    return map;
}

DepthMap filled_sparse_depth(const DepthView& view) {
    constexpr float kTriangulatedWeight = 0.02F;
    DepthMap map = sparse_depth(view);
    if (view.points.empty()) return map;
    FloatImage values = map.inverse_depth;
    FloatImage weights(values.width(), values.height(), kTriangulatedWeight);
    for (const SparsePoint& point : reliable_points(view)) {
        const int x = static_cast<int>(point.pixel.x());
        const int y = static_cast<int>(point.pixel.y());
        values(x, y) = static_cast<float>(point.inverse_depth);
        weights(x, y) = 1.0F;
    }
    map.inverse_depth = smooth_guided(values, weights, view.photograph, {});
    return map;
}

}  // namespace lumi
