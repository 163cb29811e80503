#pragma once

#include "calib/capture/capture.h"
#include "calib/poses/mapping.h"

namespace lumi {

/// Where residuals look like zoom: gives each view of `mapped` a lens of its own, if the
/// information criterion asks for it, and warns. True when it did: `mapped` is then to be refined
/// again. `mapped` is the model before the refinement, with the observations that the refinement
/// dropped.
[[nodiscard]] bool give_own_lenses(const MappingJob& job, Capture& mapped, const Capture& refined);

/// Asks of a refined model what would make it look right and be wrong. Throws Error:
///
/// - Residuals that look like a rolling shutter, where an adjustment with a turning rate for each
///   view explains more and moves a camera by more than poses may be wrong: E-POSES-SHUTTER.
/// - Verified pairs that the model denies: E-POSES-REPEATED, or what else the evidence names.
void settle_doubts(const MappingJob& job, const MatchedPhotographs& matched, const Capture& mapped,
                   const Capture& refined);

}  // namespace lumi
