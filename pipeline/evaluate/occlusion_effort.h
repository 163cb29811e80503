#pragma once

#include "pipeline/evaluate/kept_back_photographs.h"
#include "pipeline/stages/drawing_effort.h"
#include "render/lumigraph/drawing_choices.h"

namespace lumi {

/// From how far on, in pixels of disparity, a view is not to be blended any more because it sees
/// something else. Where depth is noisy a narrow tolerance takes views away at random, and what is
/// left changes from pixel to pixel; where it is right a wide one blends what hides a point with
/// it. Photographs that are kept back (kept_back_photographs.h) say how much that loses `perpixel`:
/// of the tolerances asked the least that they cannot tell from the best (the one-standard-error
/// rule). None costs more time than another. All else is drawn as `drawing` says. For fewer than
/// eight views nobody is asked. Throws Error (E-GL-...).
[[nodiscard]] OcclusionEffort sufficient_occlusion_effort(KeptBackPhotographs& photographs,
                                                          DrawingChoices drawing);

}  // namespace lumi
