#pragma once

#include <optional>

#include "render/subdivision/blend_triangles.h"
#include "render/subdivision/patch_sampler.h"

namespace lumi {

/// A place where an edge of triangles crosses the outline of a surface: one pixel, twice.
struct OutlineCrossing {
    BlendVertex at_from;  ///< On the surface of the edge's first end.
    BlendVertex at_to;    ///< On that of its second.
};

/// Looks between two vertices for the place where depth jumps, by halving, to one and a half
/// pixels.
///
/// Triangles that end there, on both sides, leave a surface its outline however long their edges
/// are; one across it would draw it out into what lies behind. Empty where photographs are looked
/// up nearly where they would be without the jump, and where depth changes bit by bit.
[[nodiscard]] std::optional<OutlineCrossing> outline_crossing(const PatchSampler& sampler,
                                                              const BlendVertex& from,
                                                              const BlendVertex& to);

}  // namespace lumi
