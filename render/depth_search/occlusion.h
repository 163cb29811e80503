#pragma once

#include <array>
#include <optional>

namespace lumi {

/// Where visible weights sum to less, no view sees the point. As in shaders/photographs.glsl.
inline constexpr double kLeastWeight = 1e-4;

/// A photograph with this weight shows something at each of its pixels that lies inside by its
/// unsure border: times the least opacity (photograph_opacity.h) it still counts.
inline constexpr double kSureWeight = 0.05;
/// How far inside of its border a photograph counts for sure at the finest mip level, in its
/// pixels; at others it is more (uploaded/photograph_lod.h).
inline constexpr double kFinestBorder_px = 1.0;

/// The paper's occlusion correction (section 4), to the letter. A view that does not see the point
/// gets 0, the others keep their ratio: (x, y, z) without z becomes (x + zx/(x+y), y + zy/(x+y),
/// 0), of two that had no weight each gets half; one that is left alone gets 1, whatever its weight
/// was; and of three that do not see it all get 0.
[[nodiscard]] std::array<double, 3> redistributed_by_the_paper(const std::array<double, 3>& weights,
                                                               const std::array<bool, 3>& is_seen);

/// The same without its jumps: weights times visibility, scaled to sum 1. Empty when no view that
/// has weight sees the point: one without weight gains none.
[[nodiscard]] std::optional<std::array<double, 3>> redistributed(
    const std::array<double, 3>& weights, const std::array<double, 3>& visibility);

/// The share of a ray's weights that occlusion takes: 1 - sum of weight times visibility; the
/// weights sum to 1.
[[nodiscard]] double occluded_share(const std::array<double, 3>& weights,
                                    const std::array<double, 3>& visibility);

/// Visibility of a point to a view whose own surface differs from it by `difference_px` of
/// disparity: 1 up to the tolerance, 0 from twice that on, a linear ramp between, so that nothing
/// jumps.
[[nodiscard]] double visibility_of(double difference_px, double tolerance_px);

/// The least disparity, in pixels, between a guess and what a view has seen before it for the guess
/// to be hidden from that view; what stands less before it may be noise. For points that were seen,
/// the photographs choose the limit (DrawingChoices::occlusion_tolerance_px).
inline constexpr double kSurelyBefore_px = 16.0;

/// The factor on a view's weight `distance_px` inside the border of its photograph: a ramp from 0
/// at the border to 1, and 0 outside.
[[nodiscard]] double border_fade(double distance_px);

}  // namespace lumi
