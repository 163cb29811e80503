#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Eyes of a film through the places of all photographs in their order, `count` of them at even
/// times; all stand upright (photograph_eye.h).
///
/// They stand on a smooth curve (PoseCurve) that leads exactly through the photographs' places; at
/// the first and the last photograph an eye stands, at those between no more than near by, as
/// frames come. Way and turn count as far as they move the picture of what is in the middle of the
/// scene's depths. Speed never jumps: it is the same all along, but for the beginning and the end,
/// which are at rest, and for sharp bends. Nothing is accelerated, sideways neither, by more than
/// what takes it from rest to that speed within half of the mean way between two photographs.
///
/// Every eye has the first view's field of view at the given size: the whole photograph fits.
[[nodiscard]] std::vector<Eye> tour_through_views(const Lumigraph& lumigraph, int count,
                                                  int width_px, int height_px);

}  // namespace lumi
