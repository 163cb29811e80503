#pragma once

#include <string>

#include "calib/capture/capture.h"
#include "calib/poses/mapping_job.h"

namespace lumi {

/// Another model of the same photographs, made where the first is in doubt.
struct SecondModel {
    Capture mapped;   ///< Before the refinement, with the observations that it dropped.
    Capture refined;  ///< After it.
    /// Why the capture is to be refused all the same (JointCheck::trouble); empty: nothing.
    std::string joint_trouble;
    std::string warning;  ///< What to know before trusting it.
};

/// Photographs and pairs, without the features that more could be matched by: what was matched has
/// to do.
[[nodiscard]] MatchedPhotographs without_features(const MatchedPhotographs& matched);

/// What is known of the model, and warned of, is what is known of the second one instead.
void tell_of_second_model(PoseEvidence& evidence, PoseEvidence of_second);

}  // namespace lumi
