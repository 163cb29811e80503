#pragma once

#include "render/subdivision/blend_triangles.h"

namespace lumi {

/// What a step of depth counts as, where its size is not known at the middle of the edge.
inline constexpr float kStepError_px = 8.0F;

/// Weights of the parts of an edge's error.
struct EdgeErrorCounts {
    /// A change of a weight from 0 to 1, so that edges of visibility are met.
    double weight_error_px = 2.0;
    /// Guesses are followed so many times less closely, as by depth meshes (depth_triangulation.h):
    /// their errors may be so many times as large, and edges among them are left so many times as
    /// long. Triangles are better spent on what was seen, and a torn guess is no truer in more
    /// pieces; but where what was seen ends is worth them.
    double guess_ratio = 4.0;
};

/// The error of linear interpolation in the middle of an edge that is left whole, the largest of
/// these: how far photographs are looked up from where they should be, weighted by their weights;
/// 2 * weight_error_px times the error of a weight or of the opacity; up to kStepError_px where the
/// photographs lose the scene along the edge. At a guess, divided by guess_ratio.
[[nodiscard]] double edge_error_px(const BlendVertex& a, const BlendVertex& b,
                                   const BlendVertex& middle, const EdgeErrorCounts& counts = {});

/// The factor by which an edge may be left longer than others: guess_ratio for an edge among
/// guesses, else 1.
[[nodiscard]] double edge_looseness(const BlendVertex& a, const BlendVertex& b,
                                    const BlendVertex& middle, const EdgeErrorCounts& counts = {});

/// The relaxation at which an edge is no longer split whose error and length are so many times
/// those that are allowed. Relaxing lets edges be longer, by its root; edges of large error stay
/// shorter, so that not all edges of one length are given up at once.
[[nodiscard]] double greatest_relaxation(double error, double length);

}  // namespace lumi
