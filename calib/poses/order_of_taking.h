#pragma once

#include <optional>

#include "calib/capture/capture.h"
#include "calib/poses/mapping_job.h"
#include "calib/poses/refinement.h"
#include "calib/poses/second_model.h"

namespace lumi {

/// Where pairs of photographs or the walk that it tells of (walk_in_rounds) contradict the model
/// (`refined`), because sides of one thing look alike, or many photographs were not placed, because
/// they share too little to be sure of: what pairs say in the order in which the photographs were
/// taken.
///
/// Who walks around a house stands next to where the photograph before was taken, and two that
/// follow each other show the same side. Photographs are mapped anew from such pairs alone, matched
/// again leniently; then, so that rounds close, with all pairs that agree with that. This model is
/// returned where it holds all photographs that the first one did (more, where they were missing,
/// and none at an uncertain place), all that follow each other agree with it, and what it denies,
/// if more than chance lets pass, was seen from another side altogether; `matched` then keeps the
/// pairs that agree, and `job.evidence` tells of it. Empty otherwise: also where steps are so wide
/// that hardly anything is seen three times in a row, or where the order is not that of a walk (one
/// photograph of each side, then the next of each).
[[nodiscard]] std::optional<SecondModel> find_model_in_order(const MappingJob& job,
                                                             MatchedPhotographs& matched,
                                                             LensPolicy policy,
                                                             const Capture& refined);

}  // namespace lumi
