#pragma once

#include <optional>

#include "calib/capture/capture.h"
#include "calib/lens/lens_choice.h"
#include "calib/poses/mapping.h"
#include "calib/poses/refinement.h"
#include "calib/poses/second_model.h"

namespace lumi {

/// Whether the photographs were zoomed, though nothing told: where photographs share a lens of
/// unknown focal length, or contradict the model (`refined`), they are mapped anew, each with a
/// lens of its own. That model is returned, and `job.evidence` tells of it, when it agrees with the
/// pairs, poses depend on it, and either the information criterion prefers it over the observations
/// that both models have, or its focal lengths differ by more than they are uncertain; empty
/// otherwise. To correct focal lengths in the old model would not do: a wrong common lens bends the
/// whole capture, and from there the right focal lengths lie beyond a barrier.
[[nodiscard]] std::optional<SecondModel> find_own_lenses(const MappingJob& job,
                                                         const MatchedPhotographs& matched,
                                                         LensPolicy policy, const Capture& refined);

}  // namespace lumi
