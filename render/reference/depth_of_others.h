#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Whether views have depth, but not all of them.
[[nodiscard]] bool lacks_depth(const Lumigraph& lumigraph);

/// The Lumigraph with depth for all views, if any has: what a view without depth sees and what is
/// hidden from it is known from the others, as the paper casts rays into geometry where there is no
/// depth map (section 4). It gets what the depth of the others that are most use comes to in its
/// place (eye_depths.h), seen where one of them sees it and filled elsewhere; where none knows
/// anything, the scene plane as a fill. As many samples a pixel as the first view with depth has.
/// In plain code: slow, and with room for all photographs once more.
[[nodiscard]] Lumigraph with_depth_of_others(const Lumigraph& lumigraph);

}  // namespace lumi
