#include "calib/mapping/triangulation.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace lumi {
namespace {

constexpr double kMinDepth = 1e-9;
constexpr std::size_t kProposals = 8;

Eigen::Vector3d direction_in_world(const Sighting& sighting) {
    return (sighting.cam_from_world.rotation.conjugate() * sighting.ray.homogeneous()).normalized();
}

/// Middle of the shortest connection of two rays; empty when they are parallel.
std::optional<Eigen::Vector3d> middle_of(const Sighting& first, const Sighting& second) {
    const Eigen::Vector3d a = centre_in_world(first.cam_from_world);
    const Eigen::Vector3d b = centre_in_world(second.cam_from_world);
    const Eigen::Vector3d u = direction_in_world(first);
    const Eigen::Vector3d v = direction_in_world(second);
    const double cosine = u.dot(v);
    const double sine2 = 1 - cosine * cosine;
    if (!(sine2 > 1e-12)) return std::nullopt;
    const Eigen::Vector3d between = b - a;
    const double along_u = (between.dot(u) - between.dot(v) * cosine) / sine2;
    const double along_v = (between.dot(u) * cosine - between.dot(v)) / sine2;
    return 0.5 * (a + along_u * u + b + along_v * v);
}

struct RayPair {
    std::size_t first = 0;
    std::size_t second = 0;
    double cosine = 1;
};

/// The pairs whose rays differ most in direction.
std::vector<RayPair> widest_pairs(std::span<const Sighting> sightings) {
    std::vector<Eigen::Vector3d> directions;
    for (const Sighting& sighting : sightings) directions.push_back(direction_in_world(sighting));
    std::vector<RayPair> pairs;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        for (std::size_t j = i + 1; j < sightings.size(); ++j) {
            pairs.push_back({i, j, directions[i].dot(directions[j])});
        }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const RayPair& a, const RayPair& b) { return a.cosine < b.cosine; });
    // Wide pairs share their rays: every so many gives each ray its turn. None is taken from before
    // `index`, where others have been put already.
    if (pairs.size() > kProposals) {
        const std::size_t spread = std::max(pairs.size(), 2 * kProposals);
        for (std::size_t index = 0; index < kProposals; ++index) {
            pairs[index] = pairs[index * spread / (2 * kProposals)];
        }
        pairs.resize(kProposals);
    }
    return pairs;
}

struct SightingAgreement {
    std::vector<char> is_inlier;
    int inliers = 0;
    double error_sum_px = 0;
};

SightingAgreement agreement_with(std::span<const Sighting> sightings, const Eigen::Vector3d& point,
                                 double max_error_px) {
    SightingAgreement agreement;
    for (const Sighting& sighting : sightings) {
        const double error_px = sighting_error_px(sighting, point);
        const bool agrees = error_px <= max_error_px;
        agreement.is_inlier.push_back(agrees ? 1 : 0);
        agreement.inliers += agrees ? 1 : 0;
        agreement.error_sum_px += agrees ? error_px : 0;
    }
    return agreement;
}

bool is_better(const SightingAgreement& a, const SightingAgreement& b) {
    if (a.inliers != b.inliers) return a.inliers > b.inliers;
    return a.error_sum_px < b.error_sum_px;
}

}  // namespace

double sighting_error_px(const Sighting& sighting, const Eigen::Vector3d& point_in_world) {
    const Eigen::Vector3d in_cam = sighting.cam_from_world * point_in_world;
    if (!(in_cam.z() > kMinDepth)) return std::numeric_limits<double>::infinity();
    return sighting.focal_length_px * (in_cam.hnormalized() - sighting.ray).norm();
}

double largest_angle_rad(std::span<const Sighting> sightings, const std::vector<char>& is_used,
                         const Eigen::Vector3d& point_in_world) {
    std::vector<Eigen::Vector3d> directions;
    for (std::size_t index = 0; index < sightings.size(); ++index) {
        if (is_used[index] == 0) continue;
        directions.push_back(
            (point_in_world - centre_in_world(sightings[index].cam_from_world)).normalized());
    }
    double smallest_cosine = 1;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        for (std::size_t j = i + 1; j < directions.size(); ++j) {
            smallest_cosine = std::min(smallest_cosine, directions[i].dot(directions[j]));
        }
    }
    return std::acos(std::clamp(smallest_cosine, -1.0, 1.0));
}

Eigen::Vector3d refined_point(std::span<const Sighting> sightings, const std::vector<char>& is_used,
                              const Eigen::Vector3d& point_in_world) {
    constexpr int kSteps = 4;
    Eigen::Vector3d point = point_in_world;
    for (int step = 0; step < kSteps; ++step) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
        for (std::size_t index = 0; index < sightings.size(); ++index) {
            if (is_used[index] == 0) continue;
            const Sighting& sighting = sightings[index];
            const Eigen::Vector3d in_cam = sighting.cam_from_world * point;
            if (!(in_cam.z() > kMinDepth)) return point_in_world;
            const Eigen::Vector2d at_depth_one = in_cam.hnormalized();
            Eigen::Matrix<double, 2, 3> by_cam;
            by_cam << 1, 0, -at_depth_one.x(), 0, 1, -at_depth_one.y();
            const Eigen::Matrix<double, 2, 3> slope =
                sighting.focal_length_px / in_cam.z() * by_cam *
                sighting.cam_from_world.rotation.toRotationMatrix();
            const Eigen::Vector2d error = sighting.focal_length_px * (at_depth_one - sighting.ray);
            normal += slope.transpose() * slope;
            gradient += slope.transpose() * error;
        }
        const Eigen::Vector3d change = normal.ldlt().solve(gradient);
        if (!change.allFinite()) return point_in_world;
        point -= change;
    }
    return point;
}

std::optional<TriangulatedPoint> triangulate(std::span<const Sighting> sightings,
                                             const TriangulationOptions& options) {
    SightingAgreement best;
    Eigen::Vector3d position = Eigen::Vector3d::Zero();
    for (const RayPair& pair : widest_pairs(sightings)) {
        const auto proposal = middle_of(sightings[pair.first], sightings[pair.second]);
        if (!proposal) continue;
        // The middle is not the least squares solution: it may miss by some pixels.
        SightingAgreement agreement =
            agreement_with(sightings, *proposal, 2 * options.max_error_px);
        if (!is_better(agreement, best)) continue;
        best = std::move(agreement);
        position = *proposal;
        if (best.inliers == static_cast<int>(sightings.size())) break;
    }
    if (best.inliers < 2) return std::nullopt;
    position = refined_point(sightings, best.is_inlier, position);
    best = agreement_with(sightings, position, options.max_error_px);
    if (best.inliers < 2) return std::nullopt;
    if (!(largest_angle_rad(sightings, best.is_inlier, position) >= options.min_angle_rad)) {
        return std::nullopt;
    }
    return TriangulatedPoint{position, std::move(best.is_inlier)};
}

}  // namespace lumi
