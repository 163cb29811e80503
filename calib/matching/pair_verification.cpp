#include "calib/matching/pair_verification.h"

#include <Eigen/LU>
#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "calib/matching/ransac_parameters.h"
#include "calib/matching/rotation_check.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

using Points = std::vector<cv::Point2d>;
using Mask = std::vector<char>;

/// Matched places in both pictures, in the pixels of pinhole cameras whose optical axes are (0, 0).
struct PointPairs {
    Points first;
    Points second;
    double first_focal_px = 1;
    double second_focal_px = 1;
};

const Camera& camera_of(int photograph, const std::vector<ColmapCamera>& cameras,
                        const std::vector<ColmapPhotograph>& photographs) {
    const int camera = photographs[static_cast<std::size_t>(photograph)].camera_index;
    return cameras[static_cast<std::size_t>(camera)].camera;
}

cv::Point2d ideal_pixel(const Camera& camera, double focal_px, const Eigen::Vector2f& pixel) {
    const Eigen::Vector3d ray = unproject(camera, pixel.cast<double>());
    return {focal_px * ray.x(), focal_px * ray.y()};
}

PointPairs point_pairs(const PairMatches& pair, const Camera& first, const Camera& second,
                       const std::vector<ColmapPhotograph>& photographs) {
    PointPairs points;
    points.first_focal_px = focal_length_px(first).mean();
    points.second_focal_px = focal_length_px(second).mean();
    const auto& first_px = photographs[static_cast<std::size_t>(pair.first)].keypoints_px;
    const auto& second_px = photographs[static_cast<std::size_t>(pair.second)].keypoints_px;
    for (const FeatureMatch& match : pair.matches) {
        points.first.push_back(ideal_pixel(first, points.first_focal_px, first_px[match.first]));
        points.second.push_back(
            ideal_pixel(second, points.second_focal_px, second_px[match.second]));
    }
    return points;
}

/// Empty when OpenCV found nothing, or found several and cannot tell which.
std::optional<Eigen::Matrix3d> matrix_of(const cv::Mat& found) {
    if (found.rows != 3 || found.cols != 3) return std::nullopt;
    Eigen::Matrix3d matrix;
    cv::cv2eigen(found, matrix);
    if (!matrix.allFinite() || matrix.norm() == 0) return std::nullopt;
    return matrix;
}

cv::Matx33d calibration_matrix(double focal_px) {
    return {focal_px, 0, 0, 0, focal_px, 0, 0, 0, 1};
}

/// second^T F first = 0.
std::optional<Eigen::Matrix3d> epipolar_matrix(const PointPairs& points, bool lens_is_calibrated,
                                               const PairVerificationOptions& options) {
    cv::Mat mask;
    const cv::UsacParams parameters = ransac_parameters(options.max_error_px, options.max_trials);
    if (!lens_is_calibrated) {
        return matrix_of(cv::findFundamentalMat(points.first, points.second, mask, parameters));
    }
    const cv::Matx33d first = calibration_matrix(points.first_focal_px);
    const cv::Matx33d second = calibration_matrix(points.second_focal_px);
    const auto essential =
        matrix_of(cv::findEssentialMat(points.first, points.second, first, second, cv::noArray(),
                                       cv::noArray(), mask, parameters));
    if (!essential) return std::nullopt;
    const Eigen::Vector3d first_inverse(1 / points.first_focal_px, 1 / points.first_focal_px, 1);
    const Eigen::Vector3d second_inverse(1 / points.second_focal_px, 1 / points.second_focal_px, 1);
    return second_inverse.asDiagonal() * *essential * first_inverse.asDiagonal();
}

Eigen::Vector3d homogeneous(const cv::Point2d& point) { return {point.x, point.y, 1.0}; }

/// Sampson's distance (Hartley and Zisserman, 2nd ed., section 11.4.3).
double epipolar_error_px(const Eigen::Matrix3d& matrix, const cv::Point2d& first,
                         const cv::Point2d& second) {
    const Eigen::Vector3d a = homogeneous(first);
    const Eigen::Vector3d b = homogeneous(second);
    const Eigen::Vector3d line_in_second = matrix * a;
    const Eigen::Vector3d line_in_first = matrix.transpose() * b;
    const double slope =
        line_in_second.head<2>().squaredNorm() + line_in_first.head<2>().squaredNorm();
    return std::abs(b.dot(line_in_second)) / std::sqrt(slope);
}

/// The larger of the distances in both pictures.
double transfer_error_px(const Eigen::Matrix3d& second_from_first,
                         const Eigen::Matrix3d& first_from_second, const cv::Point2d& first,
                         const cv::Point2d& second) {
    const Eigen::Vector3d there = second_from_first * homogeneous(first);
    const Eigen::Vector3d back = first_from_second * homogeneous(second);
    return std::max((there.hnormalized() - Eigen::Vector2d(second.x, second.y)).norm(),
                    (back.hnormalized() - Eigen::Vector2d(first.x, first.y)).norm());
}

template <class Error>
Mask inliers_by(const PointPairs& points, double max_error_px, const Error& error_px) {
    Mask mask;
    for (std::size_t index = 0; index < points.first.size(); ++index) {
        mask.push_back(error_px(points.first[index], points.second[index]) <= max_error_px ? 1 : 0);
    }
    return mask;
}

Mask epipolar_inliers(const PointPairs& points, bool lens_is_calibrated,
                      const PairVerificationOptions& options) {
    const auto matrix = epipolar_matrix(points, lens_is_calibrated, options);
    if (!matrix) return Mask(points.first.size(), 0);
    return inliers_by(points, options.max_error_px, [&](const auto& first, const auto& second) {
        return epipolar_error_px(*matrix, first, second);
    });
}

Mask homography_inliers(const PointPairs& points, const PairVerificationOptions& options) {
    cv::Mat mask;
    const auto matrix =
        matrix_of(cv::findHomography(points.first, points.second, mask,
                                     ransac_parameters(options.max_error_px, options.max_trials)));
    if (!matrix) return Mask(points.first.size(), 0);
    const Eigen::Matrix3d inverse = matrix->inverse();
    return inliers_by(points, options.max_error_px, [&](const auto& first, const auto& second) {
        return transfer_error_px(*matrix, inverse, first, second);
    });
}

std::ptrdiff_t count(const Mask& mask) { return std::count(mask.begin(), mask.end(), 1); }

bool is_turn(const PointPairs& points, const Mask& inliers, const Camera& first,
             const Camera& second) {
    DirectionPairs directions;
    for (std::size_t index = 0; index < inliers.size(); ++index) {
        if (inliers[index] == 0) continue;
        const cv::Point2d a = points.first[index] / points.first_focal_px;
        const cv::Point2d b = points.second[index] / points.second_focal_px;
        directions.first.push_back(homogeneous(a));
        directions.second.push_back(homogeneous(b));
    }
    return is_rotation(directions, first, second);
}

}  // namespace

std::optional<VerifiedPair> verify_pair(const PairMatches& pair,
                                        const std::vector<ColmapCamera>& cameras,
                                        const std::vector<ColmapPhotograph>& photographs,
                                        bool lens_is_calibrated,
                                        const PairVerificationOptions& options) {
    if (pair.matches.size() < static_cast<std::size_t>(options.min_inliers)) return std::nullopt;
    const Camera& first = camera_of(pair.first, cameras, photographs);
    const Camera& second = camera_of(pair.second, cameras, photographs);
    const PointPairs points = point_pairs(pair, first, second, photographs);
    Mask inliers = epipolar_inliers(points, lens_is_calibrated, options);
    const Mask on_plane = homography_inliers(points, options);
    VerifiedPair result{
        pair.first,
        pair.second,
        lens_is_calibrated ? PairConfiguration::kCalibrated : PairConfiguration::kUncalibrated,
        {}};
    if (static_cast<double>(count(on_plane)) >
        options.planar_share * static_cast<double>(count(inliers))) {
        if (count(on_plane) > count(inliers)) inliers = on_plane;
        result.configuration = is_turn(points, inliers, first, second)
                                   ? PairConfiguration::kPanoramic
                                   : PairConfiguration::kPlanar;
    }
    if (count(inliers) < options.min_inliers) return std::nullopt;
    for (std::size_t index = 0; index < inliers.size(); ++index) {
        if (inliers[index] != 0) result.inliers.push_back(pair.matches[index]);
    }
    return result;
}

std::vector<VerifiedPair> verify_pairs(const std::vector<PairMatches>& pairs,
                                       const std::vector<ColmapCamera>& cameras,
                                       const std::vector<ColmapPhotograph>& photographs,
                                       bool lens_is_calibrated,
                                       const PairVerificationOptions& options, int threads,
                                       Progress& progress) {
    progress.begin("verifying pairs of photographs", pairs.size());
    std::vector<std::optional<VerifiedPair>> judged(pairs.size());
    parallel_for(static_cast<int>(pairs.size()), threads, [&](int index) {
        progress.throw_if_interrupted();
        const auto position = static_cast<std::size_t>(index);
        judged[position] =
            verify_pair(pairs[position], cameras, photographs, lens_is_calibrated, options);
        progress.advance();
    });
    std::vector<VerifiedPair> verified;
    for (std::optional<VerifiedPair>& pair : judged) {
        if (pair) verified.push_back(std::move(*pair));
    }
    return verified;
}

}  // namespace lumi
