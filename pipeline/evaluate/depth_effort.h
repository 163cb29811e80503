#pragma once

#include "pipeline/evaluate/kept_back_photographs.h"
#include "pipeline/stages/drawing_effort.h"
#include "render/lumigraph/drawing_choices.h"

namespace lumi {

/// The least that photographs cannot tell from more: of the Lumigraph's own views some are kept
/// back and drawn from the others (kept_back_photographs.h).
///
/// Of how many views depth is compared the one-standard-error rule chooses: a further view shows
/// what the others do not see, but may as well be wrong. So it does of whether what they do not see
/// is drawn from others, and of whether guesses are checked, which are left out where nobody would
/// miss them; guesses are asked for with the most views and with holes filled, whatever is chosen.
/// Blocks of pixels lose a little on every silhouette, which is measured without any doubt: they
/// are chosen as wide as loses less than anyone sees (block_width.h). All else is drawn as
/// `drawing` says. For fewer than eight views nobody is asked. Throws Error (E-GL-...).
[[nodiscard]] DepthEffort sufficient_depth_effort(KeptBackPhotographs& photographs,
                                                  const DrawingChoices& drawing);

}  // namespace lumi
