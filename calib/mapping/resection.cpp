#include "calib/mapping/resection.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>

namespace lumi {
namespace {

constexpr int kMinInliers = 4;

struct PosedPoints {
    std::vector<cv::Point3d> points;
    std::vector<cv::Point2d> rays;
};

Rigid3 rigid3_of(const cv::Mat& rotation_vector, const cv::Mat& translation) {
    Eigen::Vector3d turn;
    Rigid3 pose;
    cv::cv2eigen(rotation_vector, turn);
    cv::cv2eigen(translation, pose.translation);
    const double angle = turn.norm();
    if (angle > 0) pose.rotation = Eigen::AngleAxisd(angle, turn / angle);
    return pose;
}

/// Random numbers that are the same everywhere (Marsaglia, Xorshift RNGs, 2003).
class Random {
 public:
    std::size_t below(std::size_t limit) {
        state_ ^= state_ << 13U;
        state_ ^= state_ >> 7U;
        state_ ^= state_ << 17U;
        return static_cast<std::size_t>(state_ % limit);
    }

 private:
    std::uint64_t state_ = 0x9E3779B97F4A7C15ULL;
};

/// Agreement of all points with a pose; errors are capped at the limit, so that a better fit of the
/// same points wins (MSAC: Torr and Zisserman, CVIU 2000).
struct PoseAgreement {
    Rigid3 pose;
    std::vector<char> is_inlier;
    int inliers = 0;
    double cost = 0;
};

PoseAgreement agreement_with(const Rigid3& pose, std::span<const Eigen::Vector3d> points,
                             std::span<const Eigen::Vector2d> rays, double max_error) {
    PoseAgreement agreement{pose, std::vector<char>(points.size(), 0), 0, 0};
    const Eigen::Matrix3d rotation = pose.rotation.toRotationMatrix();
    for (std::size_t index = 0; index < points.size(); ++index) {
        const Eigen::Vector3d in_cam = rotation * points[index] + pose.translation;
        double error2 = max_error * max_error;
        if (in_cam.z() > 0) {
            const double here = (in_cam.hnormalized() - rays[index]).squaredNorm();
            if (here < error2) {
                error2 = here;
                agreement.is_inlier[index] = 1;
                ++agreement.inliers;
            }
        }
        agreement.cost += error2;
    }
    return agreement;
}

std::vector<Rigid3> poses_through(const std::array<std::size_t, 3>& sample,
                                  std::span<const Eigen::Vector3d> points,
                                  std::span<const Eigen::Vector2d> rays) {
    PosedPoints three;
    for (const std::size_t index : sample) {
        three.points.emplace_back(points[index].x(), points[index].y(), points[index].z());
        three.rays.emplace_back(rays[index].x(), rays[index].y());
    }
    std::vector<cv::Mat> rotations;
    std::vector<cv::Mat> translations;
    const int found = cv::solveP3P(three.points, three.rays, cv::Matx33d::eye(), cv::noArray(),
                                   rotations, translations, cv::SOLVEPNP_P3P);
    std::vector<Rigid3> poses;
    for (int index = 0; index < found; ++index) {
        const auto position = static_cast<std::size_t>(index);
        const Rigid3 pose = rigid3_of(rotations[position], translations[position]);
        if (pose.rotation.coeffs().allFinite() && pose.translation.allFinite()) {
            poses.push_back(pose);
        }
    }
    return poses;
}

/// Trials after which, with 99.99 % certainty, one sample was free of outliers.
double trials_for(double inlier_share) {
    const double good_sample = std::pow(inlier_share, 3);
    if (good_sample >= 1) return 1;
    return std::log(1e-4) / std::log1p(-good_sample);
}

Rigid3 refined(const PoseAgreement& agreement, std::span<const Eigen::Vector3d> points,
               std::span<const Eigen::Vector2d> rays) {
    PosedPoints inliers;
    for (std::size_t index = 0; index < points.size(); ++index) {
        if (agreement.is_inlier[index] == 0) continue;
        inliers.points.emplace_back(points[index].x(), points[index].y(), points[index].z());
        inliers.rays.emplace_back(rays[index].x(), rays[index].y());
    }
    const Eigen::AngleAxisd turn(agreement.pose.rotation);
    const Eigen::Vector3d rotation_vector = turn.angle() * turn.axis();
    cv::Mat rotation;
    cv::Mat translation;
    cv::eigen2cv(rotation_vector, rotation);
    cv::eigen2cv(agreement.pose.translation, translation);
    cv::solvePnPRefineLM(inliers.points, inliers.rays, cv::Matx33d::eye(), cv::noArray(), rotation,
                         translation);
    return rigid3_of(rotation, translation);
}

}  // namespace

std::optional<Resection> resect(std::span<const Eigen::Vector3d> points_in_world,
                                std::span<const Eigen::Vector2d> rays, double focal_length_px,
                                const ResectionOptions& options) {
    const std::size_t count = points_in_world.size();
    if (count < static_cast<std::size_t>(kMinInliers)) return std::nullopt;
    const double max_error = options.max_error_px / focal_length_px;
    PoseAgreement best;
    Random random;
    double trials_wanted = options.max_trials;
    for (int trial = 0; trial < trials_wanted; ++trial) {
        std::array<std::size_t, 3> sample{random.below(count), random.below(count),
                                          random.below(count)};
        if (sample[0] == sample[1] || sample[0] == sample[2] || sample[1] == sample[2]) continue;
        for (const Rigid3& pose : poses_through(sample, points_in_world, rays)) {
            PoseAgreement agreement = agreement_with(pose, points_in_world, rays, max_error);
            if (best.inliers > 0 && agreement.cost >= best.cost) continue;
            best = std::move(agreement);
            trials_wanted = std::min<double>(
                options.max_trials,
                trials_for(static_cast<double>(best.inliers) / static_cast<double>(count)));
        }
    }
    if (best.inliers < kMinInliers) return std::nullopt;
    constexpr int kRefinements = 2;
    for (int round = 0; round < kRefinements; ++round) {
        PoseAgreement agreement =
            agreement_with(refined(best, points_in_world, rays), points_in_world, rays, max_error);
        if (agreement.cost >= best.cost) break;
        best = std::move(agreement);
    }
    return Resection{best.pose, std::move(best.is_inlier), best.inliers};
}

}  // namespace lumi
