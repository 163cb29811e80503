#include "calib/poses/model_check.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "calib/doctor/capture_reason.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr double kMinAngle_deg = 1.0;  ///< Below this depth is a guess.
constexpr double kWeakAngle_deg = 2.5;
constexpr double kMinFocalPerSide = 0.3;  ///< 118 degrees across the longer side.
constexpr double kMaxFocalPerSide = 10.0;
constexpr double kFlat = 0.005;
constexpr double kMaxFocalSpread = 2.0;

double largest_angle_rad(const std::vector<Eigen::Vector3d>& centres, const ScenePoint& point) {
    double largest = 0;
    for (std::size_t a = 0; a < point.track.size(); ++a) {
        for (std::size_t b = a + 1; b < point.track.size(); ++b) {
            const auto ray_from = [&](const Observation& observation) {
                const auto view = static_cast<std::size_t>(observation.view_index);
                return Eigen::Vector3d(point.position_in_world - centres[view]);
            };
            const Eigen::Vector3d first = ray_from(point.track[a]);
            const Eigen::Vector3d second = ray_from(point.track[b]);
            largest = std::max(largest, std::atan2(first.cross(second).norm(), first.dot(second)));
        }
    }
    return largest;
}

/// The points, of which there are two or more, without the tenth that is farthest from their
/// middle.
std::vector<Eigen::Vector3d> central_points(const Capture& capture) {
    Eigen::Vector3d middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<double> coordinates;
        for (const ScenePoint& point : capture.points) {
            coordinates.push_back(point.position_in_world[axis]);
        }
        middle[axis] = median_of(std::move(coordinates));
    }
    std::vector<Eigen::Vector3d> points;
    for (const ScenePoint& point : capture.points) points.push_back(point.position_in_world);
    std::sort(points.begin(), points.end(), [&](const auto& a, const auto& b) {
        return (a - middle).squaredNorm() < (b - middle).squaredNorm();
    });
    points.resize(points.size() * 9 / 10);
    return points;
}

void check_focal_lengths(const Capture& capture, bool lens_is_known,
                         std::vector<std::string>& warnings) {
    double smallest = std::numeric_limits<double>::infinity();
    double largest = 0;
    for (const Camera& camera : capture.cameras) {
        const double per_side =
            focal_length_px(camera).mean() / std::max(camera.width_px, camera.height_px);
        smallest = std::min(smallest, per_side);
        largest = std::max(largest, per_side);
    }
    if (lens_is_known) return;
    if (smallest < kMinFocalPerSide || largest > kMaxFocalPerSide) {
        refuse_capture(CaptureReason::kFocal,
                       formatted("the focal length came out as %.3g times the picture's longer "
                                 "side, which no ordinary lens has",
                                 smallest < kMinFocalPerSide ? smallest : largest));
    }
    if (largest > kMaxFocalSpread * smallest) {
        warnings.push_back(
            formatted("focal lengths differ by a factor of %.3g between photographs; if one lens "
                      "and zoom took them all, give it ([calibration])",
                      largest / smallest));
    }
}

}  // namespace

void refuse_turning_camera(const MotionEvidence& motion) {
    if (!motion.only_turned()) return;
    refuse_capture(CaptureReason::kNoParallax,
                   "the camera only turned on the spot: " + std::to_string(motion.rotation_pairs) +
                       " of " + std::to_string(motion.pairs) +
                       " pairs of photographs show the same view without parallax, and no depth "
                       "can come of them" +
                       turntable_hint(motion));
}

double median_triangulation_angle_deg(const Capture& capture) {
    std::vector<Eigen::Vector3d> centres;
    for (const View& view : capture.views) centres.push_back(centre_in_world(view.cam_from_world));
    std::vector<double> angles;
    for (const ScenePoint& point : capture.points) {
        angles.push_back(largest_angle_rad(centres, point));
    }
    return median_of(std::move(angles)) * 180.0 / std::numbers::pi;
}

double relative_thickness(const Capture& capture) {
    if (capture.points.size() < 4) return 0.0;
    const std::vector<Eigen::Vector3d> points = central_points(capture);
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : points) mean += point;
    mean /= static_cast<double>(points.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3d& point : points) {
        covariance += (point - mean) * (point - mean).transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
    const Eigen::Vector3d variances = solver.eigenvalues().cwiseMax(0.0);
    return variances[2] > 0 ? std::sqrt(variances[0] / variances[2]) : 0.0;
}

std::vector<std::string> check_model(const Capture& capture, bool lens_is_known) {
    std::vector<std::string> warnings;
    if (!lens_is_known && capture.views.size() < 3) {
        refuse_capture(CaptureReason::kFew,
                       "two photographs alone do not tell how far a lens of unknown focal length "
                       "turned and moved");
    }
    const double angle_deg = median_triangulation_angle_deg(capture);
    if (angle_deg < kMinAngle_deg) {
        refuse_capture(CaptureReason::kNoParallax,
                       formatted("the camera hardly moved: rays to the same point meet at %.3g "
                                 "degrees only, and depth cannot be told",
                                 angle_deg));
    }
    if (angle_deg < kWeakAngle_deg) {
        warnings.push_back(
            formatted("little parallax: rays to the same point meet at %.3g degrees; "
                      "depth is uncertain. To improve it, ",
                      angle_deg) +
            std::string(advice_for(CaptureReason::kNoParallax)));
    }
    check_focal_lengths(capture, lens_is_known, warnings);
    const double thickness = relative_thickness(capture);
    if (thickness < kFlat) {
        if (!lens_is_known) {
            refuse_capture(
                CaptureReason::kPlanar,
                "all points lie in one plane, from which an unknown focal length cannot be told");
        }
        warnings.push_back("all points lie in one plane");
    }
    return warnings;
}

}  // namespace lumi
