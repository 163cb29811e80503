#pragma once

#include <optional>
#include <vector>

#include "calib/colmap/colmap_database.h"
#include "calib/colmap/match_list.h"
#include "calib/work/progress.h"

namespace lumi {

struct PairVerificationOptions {
    /// Distance from the epipolar line (Sampson) or from the transferred pixel. Lens distortion
    /// that is not known yet must fit in. > 0.
    double max_error_px = 4.0;
    int min_inliers = 15;  ///< Fewer are chance. >= 8.
    /// A homography that explains this share of what an epipolar geometry does explains the pair.
    double planar_share = 0.8;
    int max_trials = 1000;  ///< > 0.
};

/// Which matches of a pair agree with one motion of the camera, and of what kind it is: general
/// (kCalibrated or kUncalibrated), before a plane (kPlanar), or a turn on the spot (kPanoramic).
///
/// The epipolar geometry is found by RANSAC with local optimization (OpenCV's USAC; Chum, Matas,
/// Kittler, DAGM 2003): an essential matrix when both lenses are calibrated, a fundamental one
/// otherwise; and beside it a homography. When the homography explains nearly as much, its inliers
/// count. A turn is asked for with the lenses as they are believed to be (see fit_rotation). The
/// random numbers are the same in every run. Empty when too few matches agree.
[[nodiscard]] std::optional<VerifiedPair> verify_pair(
    const PairMatches& pair, const std::vector<ColmapCamera>& cameras,
    const std::vector<ColmapPhotograph>& photographs, bool lens_is_calibrated,
    const PairVerificationOptions& options);

/// verify_pair() of all; those without a geometry are left out. The same for any number of threads.
[[nodiscard]] std::vector<VerifiedPair> verify_pairs(
    const std::vector<PairMatches>& pairs, const std::vector<ColmapCamera>& cameras,
    const std::vector<ColmapPhotograph>& photographs, bool lens_is_calibrated,
    const PairVerificationOptions& options, int threads, Progress& progress);

}  // namespace lumi
