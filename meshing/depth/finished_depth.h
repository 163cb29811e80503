#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// From what one view's photographs suggest to what is drawn: the last two steps of depth.

/// What the neighbours confirm of a view's estimate (cross_view_check.h), without islands smaller
/// than 0.05 % of the picture; the estimate itself where it needs no confirmation.
[[nodiscard]] DepthMap confirmed_depth(const DepthScene& scene,
                                       const std::vector<DepthEstimate>& estimates, int view_index);

/// How the unknown depth of a view was continued.
struct Continuation {
    /// How far from what is known each pixel lies (edge_aware_fill.h).
    FloatImage distance_px;
    /// Of pixels that the view itself did not know: kAgreed where other views agree upon them
    /// (depth_of_others.h); kHides where what was continued stands clearly before something that
    /// others know and the view does not show, and no view around sees past it (seen_past.h);
    /// else 0.
    GrayImage told;

    static constexpr std::uint8_t kAgreed = 1;
    static constexpr std::uint8_t kHides = 2;
};

/// What the photographs say of depth beyond what is confirmed, and what was found on the way.
struct Recession {
    /// By how many pixels of disparity what is continued beyond all that is known should recede,
    /// for each pixel of its distance (receding_fill.h). 0: not at all; empty: too few can tell.
    std::optional<double> slope_px;
    /// Of each view; its pictures are empty where the view was not asked.
    std::vector<Continuation> continuations;
};

/// Asks up to 32 views, evenly over the capture, of what `masks` (view_mask.h) leave in the scene.
/// Their unknown depth is continued for that, in `confirmed_maps` too, at most `threads` of them at
/// one time. Throws Interrupted like all work.
[[nodiscard]] Recession fill_recession(const DepthScene& scene, const std::vector<GrayImage>& masks,
                                       const std::vector<DepthEstimate>& estimates, int threads,
                                       const Progress& progress,
                                       std::vector<DepthMap>& confirmed_maps);

/// Gives every pixel of `map`, view `view_index` among the confirmed maps, an inverse depth: what
/// is unknown is what other views agree upon, with confidence kConfirmedByOne; or it is filled
/// along the photograph's edges from what is known around it, or recedes from it by `recession_px`.
/// Of what was filled, Continuation::kHides has confidence kConfirmedByOne, too. What is known ends
/// where the photograph does (depth_of_others.h, edge_aware_fill.h, edge_snapping.h), unless it
/// `is_exact` (depth_estimate.h): then it stays.
void fill_unknown_depth(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                        int view_index, double recession_px, DepthMap& map, bool is_exact = false);

/// The same of a map that is continued already.
void finish_continued_depth(const DepthView& view, const Continuation& continuation,
                            double recession_px, DepthMap& map, bool is_exact = false);

}  // namespace lumi
