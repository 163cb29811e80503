#pragma once

#include "render/modes/blend_triangles.h"

namespace lumi {

/// How far photographs are looked up from where they should be, in the middle of an edge that is
/// not split, each counting as its weight; or twice the error of a weight or of the opacity, which
/// counts as `weight_error_px` pixels; or a step of depth's worth, where the photographs lose the
/// scene along the edge.
[[nodiscard]] double edge_error_px(const BlendVertex& a, const BlendVertex& b,
                                   const BlendVertex& middle, double weight_error_px);

/// By how much errors are relaxed when an edge is split no more whose error and length are so many
/// times those that are allowed. Relaxed errors leave edges longer, by the root; where errors are
/// large they are shorter, so that not all edges of one length are given up at once.
[[nodiscard]] double greatest_relaxation(double error, double length);

}  // namespace lumi
