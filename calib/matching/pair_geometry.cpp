#include "calib/matching/pair_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>

#include "calib/work/median.h"

namespace lumi {
namespace {

/// Features are found to half a pixel or better; lenses that nobody has calibrated bend the rest.
constexpr double kMaxError_px = 1.5;

struct PixelPairs {
    std::vector<cv::Point2d> first;
    std::vector<cv::Point2d> second;
};

PixelPairs pixels_of(int first_photograph, int second_photograph,
                     const std::vector<FeatureMatch>& matches,
                     const std::vector<ColmapPhotograph>& photographs) {
    PixelPairs pixels;
    const auto& first = photographs[static_cast<std::size_t>(first_photograph)].keypoints_px;
    const auto& second = photographs[static_cast<std::size_t>(second_photograph)].keypoints_px;
    for (const FeatureMatch& match : matches) {
        const Eigen::Vector2f& a = first[match.first];
        const Eigen::Vector2f& b = second[match.second];
        pixels.first.emplace_back(a.x(), a.y());
        pixels.second.emplace_back(b.x(), b.y());
    }
    return pixels;
}

cv::UsacParams consensus(double threshold) {
    cv::UsacParams parameters;
    parameters.threshold = threshold;
    parameters.confidence = 0.999;
    parameters.maxIterations = 1000;
    parameters.score = cv::SCORE_METHOD_MAGSAC;
    parameters.loMethod = cv::LOCAL_OPTIM_SIGMA;
    parameters.sampler = cv::SAMPLING_UNIFORM;
    parameters.isParallel = false;
    parameters.randomGeneratorState = 1;
    return parameters;
}

/// Directions (x, y) at depth 1.
std::vector<cv::Point2d> directions_of(const std::vector<cv::Point2d>& pixels,
                                       const Camera& camera) {
    std::vector<cv::Point2d> directions;
    for (const cv::Point2d& pixel : pixels) {
        const Eigen::Vector3d ray = unproject(camera, {pixel.x, pixel.y});
        directions.emplace_back(ray.x(), ray.y());
    }
    return directions;
}

bool in_view(const Camera& camera, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d ahead = direction.z() < 0 ? Eigen::Vector3d(-direction) : direction;
    const auto pixel = project(camera, ahead);
    return pixel && is_inside(camera, *pixel);
}

/// The angles at which the rays of a motion meet, in degrees.
double median_angle_deg(const PixelPairs& directions, const Eigen::Quaterniond& second_from_first) {
    std::vector<double> angles;
    for (std::size_t index = 0; index < directions.first.size(); ++index) {
        const Eigen::Vector3d first(directions.first[index].x, directions.first[index].y, 1);
        const Eigen::Vector3d second(directions.second[index].x, directions.second[index].y, 1);
        const Eigen::Vector3d turned = second_from_first * first;
        angles.push_back(std::atan2(turned.cross(second).norm(), turned.dot(second)));
    }
    return angles.empty() ? 0.0 : median_of(std::move(angles)) * 180.0 / std::numbers::pi;
}

void recover_motion(PairGeometry& geometry, const PixelPairs& directions, const Camera& first,
                    const Camera& second) {
    const double focal_px = 0.5 * (focal_length_px(first).mean() + focal_length_px(second).mean());
    const cv::UsacParams parameters = consensus(kMaxError_px / focal_px);
    const cv::Mat identity = cv::Mat::eye(3, 3, CV_64F);
    cv::Mat mask;
    const cv::Mat essential =
        cv::findEssentialMat(directions.first, directions.second, identity, identity, cv::noArray(),
                             cv::noArray(), mask, parameters);
    if (essential.rows != 3 || essential.cols != 3) return;
    cv::Mat rotation;
    cv::Mat translation;
    if (cv::recoverPose(essential, directions.first, directions.second, identity, rotation,
                        translation, mask) < 8) {
        return;
    }
    Eigen::Matrix3d matrix;
    Eigen::Vector3d second_from_first_translation;
    for (int row = 0; row < 3; ++row) {
        second_from_first_translation[row] = translation.at<double>(row);
        for (int column = 0; column < 3; ++column) {
            matrix(row, column) = rotation.at<double>(row, column);
        }
    }
    const Eigen::Quaterniond second_from_first(matrix);
    geometry.second_from_first = second_from_first;
    geometry.direction_in_first = -(second_from_first.conjugate() * second_from_first_translation);
    geometry.median_angle_deg = median_angle_deg(directions, second_from_first);
    geometry.epipoles_in_view = in_view(first, geometry.direction_in_first) &&
                                in_view(second, second_from_first_translation);
}

}  // namespace

PairGeometry pair_geometry_of(const VerifiedPair& pair,
                              const std::vector<ColmapPhotograph>& photographs,
                              const std::vector<ColmapCamera>& cameras) {
    PairGeometry geometry;
    geometry.pair = pair;
    const auto lens = [&](int photograph) -> const Camera& {
        const int camera = photographs[static_cast<std::size_t>(photograph)].camera_index;
        return cameras[static_cast<std::size_t>(camera)].camera;
    };
    const PixelPairs pixels = pixels_of(pair.first, pair.second, pair.inliers, photographs);
    recover_motion(geometry,
                   {directions_of(pixels.first, lens(pair.first)),
                    directions_of(pixels.second, lens(pair.second))},
                   lens(pair.first), lens(pair.second));
    return geometry;
}

}  // namespace lumi
