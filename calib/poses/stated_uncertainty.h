#pragma once

#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/poses/pose_shift.h"
#include "calib/poses/pose_stage.h"

namespace lumi {

/// How far two standard deviations move cameras.
struct PlaceUncertainty {
    int views = 0;    ///< Such that are moved by more than poses may be off (PoseShift::matters).
    PoseShift worst;  ///< Of all.
};

[[nodiscard]] PlaceUncertainty place_uncertainty(const Capture& capture,
                                                 const std::vector<ViewUncertainty>& views);

/// What to know of the stated uncertainties (`views`, of refine) before trusting poses: that they
/// are not known, that pictures may show ghosts where they are blended, and (E-POSES-UNCERTAIN)
/// that two standard deviations of a camera's place or attitude are more than poses may be off
/// (PoseShift::matters).
[[nodiscard]] std::vector<std::string> warnings_of_uncertainty(
    const Capture& capture, const std::vector<ViewUncertainty>& views);

}  // namespace lumi
