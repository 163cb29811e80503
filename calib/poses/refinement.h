#pragma once

#include <string>
#include <vector>

#include "calib/adjust/lens_selection.h"
#include "calib/capture/capture.h"
#include "calib/poses/pose_stage.h"

namespace lumi {

/// What is known of the lenses before the refinement, and what may be asked of them.
enum class LensPolicy {
    kAuto,   ///< Unknown: the simplest form that the photographs cannot tell from a richer one.
    kNamed,  ///< Unknown: the model of the mapping, its principal point in the middle.
    kGiven,  ///< Calibrated: refined only as far as the photographs predict better by it.
    kFocalLength,  ///< Known but for the focal length: nothing else is adjusted.
    kHeld,         ///< Calibrated: as it is.
};

[[nodiscard]] LensPolicy lens_policy(bool is_given, const PoseOptions& options);

/// Poses, points and lenses as the photographs support them.
///
/// Adjusts with a lens that can bend (RADIAL), so that a simpler one does not pass its own errors
/// off as outliers; drops views that see too little, and cameras without a view; chooses the form
/// of each lens by prediction of held-out views (select_lens); adjusts again; drops parameters
/// within two standard deviations of nothing (supported_lens), and then adjusts for the last time.
/// Writes what speaks for the result into `evidence` (lenses, noise, uncertainty of views). Throws
/// Error as adjust_bundle.
///
/// Errors that go through whole pictures, as residual_pattern shows them, count twice: a principal
/// point is then kept in the middle unless held-out views surely ask for it, and uncertainties are
/// those of noise with a variance so much larger.
///
/// Where residuals look as if each picture had a focal length of its own, and no longer do once a
/// principal point that held-out views did not ask for is free, it is (kAuto).
void refine(Capture& capture, LensPolicy policy, const PoseOptions& options, int threads,
            PoseEvidence& evidence, Progress& progress);

}  // namespace lumi
