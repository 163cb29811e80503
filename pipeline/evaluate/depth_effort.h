#pragma once

#include "pipeline/evaluate/kept_back_photographs.h"
#include "pipeline/stages/drawing_effort.h"
#include "render/lumigraph/drawing_choices.h"

namespace lumi {

/// The least that photographs cannot tell from more: of the Lumigraph's own views some are kept
/// back and drawn from the others (kept_back_photographs.h).
///
/// The one-standard-error rule chooses how many views' depth is compared: a further view shows what
/// the others miss, but may as well be wrong. It also decides whether what they miss is drawn from
/// others, and whether guesses are checked; neither is done where nobody would miss it. Photographs
/// look from among the others: where nobody would see in them whether it pays to draw from others,
/// eyes that look from a third nearer and farther are asked how much more of their picture they
/// know by it, which is done from a hundredth on. Blocks of pixels lose a little on every
/// silhouette, which is measured without any doubt: they are chosen as wide as loses less than
/// anyone sees (block_width.h). All else is drawn as `drawing` says.
///
/// As many views' depth is compared as are given, unless 0 are, and holes are judged with as many.
/// Blocks are judged with the fewest, and guesses with the most and with holes filled, whatever is
/// given or chosen. For fewer than eight views nobody is asked. Throws Error (E-GL-...).
[[nodiscard]] DepthEffort sufficient_depth_effort(KeptBackPhotographs& photographs,
                                                  const DrawingChoices& drawing,
                                                  int given_views = 0);

}  // namespace lumi
