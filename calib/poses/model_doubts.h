#pragma once

#include "calib/capture/capture.h"
#include "calib/poses/mapping_job.h"

namespace lumi {

/// True when most pairs seem to have only turned, and rays to the same point hardly meet: before a
/// wall a camera that steps sideways seems to turn, too.
[[nodiscard]] bool lacks_parallax(const MotionEvidence& motion, const Capture& model);

/// Asks of a refined model what would make it look right and be wrong. Throws Error:
///
/// - Verified pairs that the model denies, in whole or, of photographs that follow each other, by a
///   fifth, and that see things from another side altogether: E-POSES-REPEATED, unless poor
///   pictures or clutter explain it.
/// - Residuals that look like a rolling shutter, where an adjustment with a turning rate for each
///   view explains more and moves a camera by more than poses may be wrong: E-POSES-SHUTTER; or
///   E-POSES-SHIFTED where a principal point and a scale of each picture's own explain more still.
/// - Pairs that are denied for no such cause: E-POSES-UNCERTAIN. Where they are outweighed: a
///   warning alone.
/// - Most pairs seem to have only turned, and rays to the same point hardly meet: E-POSES-ROTATION.
///
/// `mapped` is the model before the refinement, with the observations that it dropped.
void settle_doubts(const MappingJob& job, const MatchedPhotographs& matched, const Capture& mapped,
                   const Capture& refined);

}  // namespace lumi
