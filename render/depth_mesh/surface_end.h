#pragma once

#include <cstddef>
#include <span>

namespace lumi {

/// So many samples of a surface tell how deep it is where it ends.
inline constexpr std::size_t kEndSamples = 3;

/// The inverse depth of a surface where it ends: halfway between its last sample in a row or column
/// and the next one, `beyond`, from which it tears. `last_samples` are its last one to three, from
/// the tear back.
///
/// Inverse depth is affine in the picture of a plane, and so the slope of the last samples goes on.
/// Where a smooth surface turns away from the view, before what it tears from, slopes grow without
/// end: near its outline the place is a parabola of inverse depth. Three samples tell the depth of
/// its vertex, if that lies before the next sample. What a surface shows to other views beyond its
/// outline falls behind it; at the depth of its last sample it would stand out there. It goes no
/// more than half of the way to what is beyond, nor behind infinity.
[[nodiscard]] float inverse_depth_at_end(std::span<const float> last_samples, float beyond);

}  // namespace lumi
