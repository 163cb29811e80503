#pragma once

#include <cstddef>
#include <span>

namespace lumi {

/// So many samples of a surface tell where it ends.
inline constexpr std::size_t kEndSamples = 3;

/// Where two surfaces end that tear from each other.
struct SurfaceEnds {
    float share;  ///< Of the way from the last sample of the nearer one to the first of the other.
    float nearer_inverse_depth;  ///< There.
    float farther_inverse_depth;
};

/// Where surfaces end between two samples of a row or column that they tear between. `nearer` and
/// `farther` are inverse depths of their last one to three samples, from the tear back.
///
/// Inverse depth is affine in the picture of a plane, and so the slope of the last samples goes on;
/// nothing tells where to, and the middle is half a sample off at most. Where the nearer surface is
/// smooth and turns away from the view, the place is, near its outline, a parabola of inverse
/// depth: three samples tell where its vertex is, if that lies before the next sample. Neither goes
/// more than half of the way to the other, nor behind infinity.
[[nodiscard]] SurfaceEnds surface_ends(std::span<const float> nearer,
                                       std::span<const float> farther);

}  // namespace lumi
