#include "calib/mapping/two_view_start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

#include "calib/matching/ransac_parameters.h"
#include "calib/matching/rotation_check.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr int kTrials = 1000;
constexpr std::size_t kPairsLookedAt = 16;

struct Candidate {
    const VerifiedPair* pair = nullptr;
    double promise = 0;
};

/// Rays of a pair's matches, in the first and in the second photograph.
struct MatchedRays {
    std::vector<Eigen::Vector2d> first;
    std::vector<Eigen::Vector2d> second;
};

/// Of the matches whose features tracks use: of others the model knows no ray.
MatchedRays rays_of(const GrowingModel& model, const VerifiedPair& pair) {
    const auto first = static_cast<std::size_t>(pair.first);
    const auto second = static_cast<std::size_t>(pair.second);
    MatchedRays rays;
    for (const FeatureMatch& match : pair.inliers) {
        if (model.track_of_feature[first][match.first] < 0 ||
            model.track_of_feature[second][match.second] < 0) {
            continue;
        }
        rays.first.push_back(model.rays[first][match.first]);
        rays.second.push_back(model.rays[second][match.second]);
    }
    return rays;
}

/// Matches, by how far from them the rotation that explains most leaves the half it explains worst;
/// pairs before a plane count less, pairs of a camera that turned not at all.
double promise_of(const GrowingModel& model, const VerifiedPair& pair) {
    constexpr double kPlentyOfParallax_rad = 0.05;
    constexpr double kNoParallax_px = 2.0;
    // Before a plane the motion is ambiguous and the focal length cannot be told.
    constexpr double kPlanarPenalty = 0.3;
    if (pair.configuration == PairConfiguration::kPanoramic) return 0;
    const MatchedRays rays = rays_of(model, pair);
    DirectionPairs directions;
    for (const Eigen::Vector2d& ray : rays.first) directions.first.push_back(ray.homogeneous());
    for (const Eigen::Vector2d& ray : rays.second) directions.second.push_back(ray.homogeneous());
    const Eigen::Quaterniond turn = fit_rotation(directions, 0.01).second_from_first;
    std::vector<double> angles_rad;
    for (std::size_t index = 0; index < directions.first.size(); ++index) {
        const Eigen::Vector3d turned = turn * directions.first[index];
        const Eigen::Vector3d& seen = directions.second[index];
        angles_rad.push_back(std::atan2(turned.cross(seen).norm(), turned.dot(seen)));
    }
    const double parallax_rad = median_of(std::move(angles_rad));
    const double focal_px = focal_length_px(model.camera_of(pair.first)).mean();
    if (parallax_rad * focal_px < kNoParallax_px) return 0;
    const bool is_general = pair.configuration == PairConfiguration::kCalibrated ||
                            pair.configuration == PairConfiguration::kUncalibrated;
    return static_cast<double>(rays.first.size()) *
           std::min(parallax_rad / kPlentyOfParallax_rad, 1.0) *
           (is_general ? 1.0 : kPlanarPenalty);
}

std::vector<Candidate> most_promising(const GrowingModel& model,
                                      const std::vector<VerifiedPair>& pairs,
                                      const TwoViewStartOptions& options) {
    std::vector<Candidate> candidates;
    for (const VerifiedPair& pair : pairs) {
        if (model.is_placed[static_cast<std::size_t>(pair.first)] != 0 ||
            model.is_placed[static_cast<std::size_t>(pair.second)] != 0 ||
            pair.inliers.size() < static_cast<std::size_t>(options.min_points)) {
            continue;
        }
        candidates.push_back({&pair, promise_of(model, pair)});
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const auto& a, const auto& b) { return a.promise > b.promise; });
    if (candidates.size() > kPairsLookedAt) candidates.resize(kPairsLookedAt);
    std::erase_if(candidates, [](const Candidate& candidate) { return !(candidate.promise > 0); });
    return candidates;
}

double weight_of(const TwoViewStart& start, const MatchedRays& rays, double focal_px,
                 const TwoViewStartOptions& options) {
    double weight = 0;
    int points = 0;
    for (std::size_t index = 0; index < rays.first.size(); ++index) {
        const std::array<Sighting, 2> sightings{
            Sighting{{}, rays.first[index], focal_px},
            Sighting{start.second_from_first, rays.second[index], focal_px}};
        const auto point = triangulate(sightings, {options.max_error_px, options.min_angle_rad});
        if (!point) continue;
        const double angle =
            largest_angle_rad(sightings, point->is_inlier, point->position_in_world);
        weight += std::min(angle / options.full_angle_rad, 1.0);
        ++points;
    }
    return points < options.min_points ? 0 : weight;
}

TwoViewStart start_from(const GrowingModel& model, const VerifiedPair& pair,
                        const TwoViewStartOptions& options) {
    TwoViewStart start{pair.first, pair.second, {}, 0};
    const MatchedRays rays = rays_of(model, pair);
    if (rays.first.size() < static_cast<std::size_t>(options.min_points)) return start;
    const double focal_px = 0.5 * (focal_length_px(model.camera_of(pair.first)).mean() +
                                   focal_length_px(model.camera_of(pair.second)).mean());
    // In pixels of a common focal length, because the threshold is one.
    std::vector<cv::Point2d> first_px;
    std::vector<cv::Point2d> second_px;
    for (const Eigen::Vector2d& ray : rays.first) {
        first_px.emplace_back(focal_px * ray.x(), focal_px * ray.y());
    }
    for (const Eigen::Vector2d& ray : rays.second) {
        second_px.emplace_back(focal_px * ray.x(), focal_px * ray.y());
    }
    const cv::Matx33d calibration(focal_px, 0, 0, 0, focal_px, 0, 0, 0, 1);
    cv::Mat mask;
    const cv::Mat essential =
        cv::findEssentialMat(first_px, second_px, calibration, calibration, cv::noArray(),
                             cv::noArray(), mask, ransac_parameters(options.max_error_px, kTrials));
    if (essential.rows != 3 || essential.cols != 3) return start;
    cv::Mat rotation;
    cv::Mat translation;
    cv::recoverPose(essential, first_px, second_px, cv::Mat(calibration), rotation, translation,
                    mask);
    Eigen::Matrix3d turn;
    cv::cv2eigen(rotation, turn);
    cv::cv2eigen(translation, start.second_from_first.translation);
    if (!turn.allFinite() || !start.second_from_first.translation.allFinite()) return start;
    start.second_from_first.rotation = Eigen::Quaterniond(turn).normalized();
    start.weight = weight_of(start, rays, focal_px, options);
    return start;
}

}  // namespace

std::vector<TwoViewStart> two_view_starts(const GrowingModel& model,
                                          const std::vector<VerifiedPair>& pairs,
                                          const TwoViewStartOptions& options) {
    std::vector<TwoViewStart> starts;
    for (const Candidate& candidate : most_promising(model, pairs, options)) {
        const TwoViewStart start = start_from(model, *candidate.pair, options);
        if (start.weight > 0) starts.push_back(start);
    }
    std::stable_sort(starts.begin(), starts.end(),
                     [](const auto& a, const auto& b) { return a.weight > b.weight; });
    return starts;
}

}  // namespace lumi
