#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "calib/colmap/colmap_database.h"
#include "calib/work/progress.h"

namespace lumi {

/// What the verified pairs say about the motion of the camera.
struct MotionEvidence {
    int pairs = 0;              ///< Verified pairs with enough matches to tell.
    int rotation_pairs = 0;     ///< Of these, explained by a camera that turned on the spot.
    int planar_pairs = 0;       ///< Of these, explained by a homography, in COLMAP's judgement.
    double turned_share = 0.0;  ///< Of the matches in a pair, as a turn moves them: mean.
    int still_pairs = 0;        ///< Of the pairs, such whose middle match lies where it lay before.

    [[nodiscard]] double rotation_share() const {
        return pairs == 0 ? 0.0 : static_cast<double>(rotation_pairs) / pairs;
    }
    [[nodiscard]] double planar_share() const {
        return pairs == 0 ? 0.0 : static_cast<double>(planar_pairs) / pairs;
    }
    /// Nearly all pairs are explained by a turn, and nearly all of what is seen in them. Sideways
    /// before a wall, most pairs are explained so, too, but not what stands before the wall.
    [[nodiscard]] bool only_turned() const {
        constexpr double kNearlyAll = 0.9;
        return rotation_share() >= kNearlyAll && turned_share >= kNearlyAll;
    }
    /// Most pairs are of a camera that stood still: then it may be the subject that turned, before
    /// something that stood still with the camera.
    [[nodiscard]] bool stood_still() const { return 2 * still_pairs > pairs; }
};

/// What to think of where the camera stood still, to follow what was found; else empty.
[[nodiscard]] std::string turntable_hint(const MotionEvidence& motion);

/// Two lists of directions, (x, y, 1), that the same scene points were seen in.
struct DirectionPairs {
    std::vector<Eigen::Vector3d> first;
    std::vector<Eigen::Vector3d> second;
};

/// The rotation second_from_first that most directions agree with, by least squares (Kabsch 1976)
/// over those that agreed before, repeated; and the share of them that it moves to within
/// `tolerance_rad`.
struct RotationFit {
    Eigen::Quaterniond second_from_first = Eigen::Quaterniond::Identity();
    double inlier_share = 0.0;
};
[[nodiscard]] RotationFit fit_rotation(const DirectionPairs& directions, double tolerance_rad);

/// The share of the directions that one rotation moves onto one another, within what lens
/// distortion and the sway of a hand leave; and whether these are most.
[[nodiscard]] double turned_share(const DirectionPairs& directions, const Camera& first,
                                  const Camera& second);
[[nodiscard]] bool is_rotation(const DirectionPairs& directions, const Camera& first,
                               const Camera& second);

/// Asks of every pair whether a rotation alone explains its matches: then there is no parallax, and
/// no depth can come of it (homographies of the form K R K^-1: Hartley and Zisserman, Multiple View
/// Geometry, 2nd ed., section 13.6). Unless the lens is calibrated, the focal length for
/// which most pairs of two lenses are rotations speaks for all of them. Throws Error:
/// E-INTERRUPTED.
[[nodiscard]] MotionEvidence check_motion(const std::vector<ColmapCamera>& cameras,
                                          const std::vector<ColmapPhotograph>& photographs,
                                          const std::vector<VerifiedPair>& pairs,
                                          bool lens_is_calibrated, const Progress& progress);

}  // namespace lumi
