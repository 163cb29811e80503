#include "calib/matching/rotation_check.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "calib/lens/lens_form.h"
#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr std::size_t kMinInliersToJudge = 20;  ///< Fewer say nothing.
constexpr std::size_t kEnoughMatches = 100;     ///< More say the same.
/// Of the longer side. Leaves room for lens distortion and for the sway of a hand-held panorama;
/// real panoramas were seen at a third to a half of it, captures with parallax far beyond it.
constexpr double kTurnToleranceShare = 0.008;
constexpr double kStillShare = 0.002;         ///< Of the longer side: where nothing moved.
constexpr double kRotationInlierShare = 0.7;  ///< So many matches must agree.

bool is_homography(PairConfiguration configuration) {
    return configuration == PairConfiguration::kPlanar ||
           configuration == PairConfiguration::kPanoramic ||
           configuration == PairConfiguration::kPlanarOrPanoramic;
}

double longer_side_px(const Camera& camera) { return std::max(camera.width_px, camera.height_px); }

Eigen::Quaterniond least_squares_rotation(const DirectionPairs& directions,
                                          const std::vector<char>& is_used) {
    Eigen::Matrix3d correlation = Eigen::Matrix3d::Zero();
    for (std::size_t index = 0; index < directions.first.size(); ++index) {
        if (is_used[index] == 0) continue;
        correlation += directions.second[index].normalized() *
                       directions.first[index].normalized().transpose();
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(correlation,
                                                Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d proper = Eigen::Matrix3d::Identity();
    proper(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return Eigen::Quaterniond(svd.matrixU() * proper * svd.matrixV().transpose());
}

std::vector<double> angles_rad(const DirectionPairs& directions,
                               const Eigen::Quaterniond& second_from_first) {
    std::vector<double> angles;
    for (std::size_t index = 0; index < directions.first.size(); ++index) {
        const Eigen::Vector3d turned = (second_from_first * directions.first[index]).normalized();
        const Eigen::Vector3d seen = directions.second[index].normalized();
        angles.push_back(std::atan2(turned.cross(seen).norm(), turned.dot(seen)));
    }
    return angles;
}

double turned_share(const VerifiedPair& pair, const Camera& first, const Camera& second,
                    const std::vector<ColmapPhotograph>& photographs) {
    DirectionPairs directions;
    const auto& first_pixels = photographs[static_cast<std::size_t>(pair.first)].keypoints_px;
    const auto& second_pixels = photographs[static_cast<std::size_t>(pair.second)].keypoints_px;
    const std::size_t step = 1 + pair.inliers.size() / kEnoughMatches;
    for (std::size_t index = 0; index < pair.inliers.size(); index += step) {
        const FeatureMatch& match = pair.inliers[index];
        directions.first.push_back(unproject(first, first_pixels[match.first].cast<double>()));
        directions.second.push_back(unproject(second, second_pixels[match.second].cast<double>()));
    }
    return turned_share(directions, first, second);
}

/// Of the pairs of two lenses: how many are turns, and the sum of their shares of turned matches.
struct Turns {
    int pairs = 0;
    double shares = 0.0;

    auto operator<=>(const Turns&) const = default;
};

Turns turns_among(const std::vector<const VerifiedPair*>& pairs, const Camera& first,
                  const Camera& second, const std::vector<ColmapPhotograph>& photographs,
                  const Progress& progress) {
    Turns turns;
    for (const VerifiedPair* pair : pairs) {
        progress.throw_if_interrupted();
        const double share = turned_share(*pair, first, second, photographs);
        if (share >= kRotationInlierShare) ++turns.pairs;
        turns.shares += share;
    }
    return turns;
}

/// Focal lengths as multiples of what is believed: EXIF is wrong by a factor of three where a
/// program resized or cropped the photograph.
std::vector<double> focal_length_factors(bool lens_is_calibrated) {
    if (lens_is_calibrated) return {1.0};
    std::vector<double> factors;
    for (double factor = 0.25; factor < 4.0; factor *= 1.1) factors.push_back(factor);
    return factors;
}

/// The median distance of its matches from where they lay is within the sway of a tripod.
bool is_still(const VerifiedPair& pair, const std::vector<ColmapPhotograph>& photographs,
              double tolerance_px) {
    const auto& first = photographs[static_cast<std::size_t>(pair.first)].keypoints_px;
    const auto& second = photographs[static_cast<std::size_t>(pair.second)].keypoints_px;
    const auto still =
        std::count_if(pair.inliers.begin(), pair.inliers.end(), [&](const FeatureMatch& match) {
            return static_cast<double>((first[match.first] - second[match.second]).norm()) <=
                   tolerance_px;
        });
    return 2 * static_cast<std::size_t>(still) > pair.inliers.size();
}

}  // namespace

std::string turntable_hint(const MotionEvidence& motion) {
    if (!motion.stood_still()) return "";
    return "; the camera stood still in " + std::to_string(motion.still_pairs) + " of " +
           std::to_string(motion.pairs) +
           " pairs: if the subject turned before it, as on a turntable, name masks of the subject "
           "under [poses] masks, and under [depth] masks, or the room is drawn as part of it; if "
           "nothing turned, the camera has to move";
}

RotationFit fit_rotation(const DirectionPairs& directions, double tolerance_rad) {
    RotationFit fit;
    const std::size_t count = directions.first.size();
    if (count < 2) return fit;
    constexpr int kRepetitions = 8;
    std::vector<char> is_used(count, 1);
    for (int repetition = 0; repetition < kRepetitions; ++repetition) {
        fit.second_from_first = least_squares_rotation(directions, is_used);
        const std::vector<double> angles = angles_rad(directions, fit.second_from_first);
        // While the fit is still pulled by outliers, the better half leads.
        const double limit = std::max(tolerance_rad, median_of(angles));
        const std::vector<char> was_used = is_used;
        std::size_t inliers = 0;
        for (std::size_t index = 0; index < count; ++index) {
            is_used[index] = angles[index] <= limit ? 1 : 0;
            if (angles[index] <= tolerance_rad) ++inliers;
        }
        fit.inlier_share = static_cast<double>(inliers) / static_cast<double>(count);
        if (is_used == was_used) break;
    }
    return fit;
}

double turned_share(const DirectionPairs& directions, const Camera& first, const Camera& second) {
    const double tolerance_px =
        kTurnToleranceShare * std::max(longer_side_px(first), longer_side_px(second));
    const double tolerance_rad = tolerance_px / focal_length_px(first).mean();
    return fit_rotation(directions, tolerance_rad).inlier_share;
}

bool is_rotation(const DirectionPairs& directions, const Camera& first, const Camera& second) {
    return turned_share(directions, first, second) >= kRotationInlierShare;
}

MotionEvidence check_motion(const std::vector<ColmapCamera>& cameras,
                            const std::vector<ColmapPhotograph>& photographs,
                            const std::vector<VerifiedPair>& pairs, bool lens_is_calibrated,
                            const Progress& progress) {
    MotionEvidence evidence;
    double turned_shares = 0;
    std::map<std::pair<int, int>, std::vector<const VerifiedPair*>> pairs_of_lenses;
    const auto lens_index = [&](int photograph) {
        return photographs[static_cast<std::size_t>(photograph)].camera_index;
    };
    for (const VerifiedPair& pair : pairs) {
        if (pair.inliers.size() < kMinInliersToJudge) continue;
        ++evidence.pairs;
        if (is_homography(pair.configuration)) ++evidence.planar_pairs;
        const Camera& lens = cameras[static_cast<std::size_t>(lens_index(pair.first))].camera;
        if (is_still(pair, photographs, kStillShare * longer_side_px(lens))) {
            ++evidence.still_pairs;
        }
        pairs_of_lenses[{lens_index(pair.first), lens_index(pair.second)}].push_back(&pair);
    }
    for (const auto& [lenses, group] : pairs_of_lenses) {
        Turns most;
        for (const double factor : focal_length_factors(lens_is_calibrated)) {
            const auto lens = [&](int index) {
                const Camera& camera = cameras[static_cast<std::size_t>(index)].camera;
                return with_focal_length_scaled(camera, factor);
            };
            const Camera first = lens(lenses.first);
            const Camera second = lens(lenses.second);
            most = std::max(most, turns_among(group, first, second, photographs, progress));
        }
        evidence.rotation_pairs += most.pairs;
        turned_shares += most.shares;
    }
    evidence.turned_share = turned_shares / std::max(1, evidence.pairs);
    return evidence;
}

}  // namespace lumi
