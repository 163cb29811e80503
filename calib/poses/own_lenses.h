#pragma once

#include <optional>

#include "calib/capture/capture.h"
#include "calib/lens/lens_choice.h"
#include "calib/poses/mapping_job.h"
#include "calib/poses/refinement.h"
#include "calib/poses/second_model.h"

namespace lumi {

/// A model in which each photograph has a lens of its own, beside one with shared lenses.
struct ZoomEvidence {
    double more_explained = 0.0;  ///< Observations, as a share of those that shared lenses explain.
    bool leaves_less = false;     ///< Of what both explain: clearly less than shared lenses do.
    bool leaves_more = false;     ///< Far more: its lenses are too simple.
    bool is_certain = false;      ///< Its focal lengths are sure to differ, by its own account.

    /// Small zooms leave about as much of what both models explain, and poses differ: then the one
    /// counts that assumes less, if its focal lengths are sure to differ and it explains more. A
    /// group of photographs that hardly overlap with the others may seem to be zoomed, from as much
    /// farther away: the same observations allow both, and nothing more is explained.
    [[nodiscard]] bool is_told() const;
};

/// Whether the photographs were zoomed, though nothing told: where photographs share a lens of
/// unknown focal length, or contradict the model (`refined`), they are mapped anew, each with a
/// lens of its own. That model is returned, and `job.evidence` tells of it, when it agrees with the
/// pairs, poses depend on it, and either the information criterion prefers it over the observations
/// that both models have, or its focal lengths differ by more than they are uncertain and it
/// explains more (ZoomEvidence); empty otherwise. To correct focal lengths in the old model would
/// not do: a wrong common lens bends the whole capture, and from there the right focal lengths lie
/// beyond a barrier.
[[nodiscard]] std::optional<SecondModel> find_own_lenses(const MappingJob& job,
                                                         const MatchedPhotographs& matched,
                                                         LensPolicy policy, const Capture& refined);

}  // namespace lumi
