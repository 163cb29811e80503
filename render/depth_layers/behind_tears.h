#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace lumi {

/// What a view has seen behind what it stretches over a tear in its depth, as the eye looks.
///
/// Through the tear the eye's ray enters what is hidden from the view behind the tear's near side,
/// and only comes out again where the view sees the point: whether something stands in between
/// others must say. From nearer than all photographs the shoulder of a statue hides its hip from
/// every view that is asked, and all of them agree on the wall that they see beside both.
///
/// The last bit of a seen depth tells it, in layers of depth and in shaders/agreed_depth.glsl.
[[nodiscard]] inline float told_behind_tear(float depth, bool is_behind) {
    const std::uint32_t without = std::bit_cast<std::uint32_t>(depth) & ~1U;
    return std::bit_cast<float>(without | (is_behind ? 1U : 0U));
}

/// Of a layer's texels, which hold what the view has seen or filled, marks what it has seen behind
/// what it stretches, by more than `agreeing_depth`; where nothing else is known the stretched
/// stays. All are in units of the depth buffer, and in their kinds' ranges (depth_kind_ranges.h).
void lay_before_tears(std::span<float> texels, std::span<const float> stretched,
                      float agreeing_depth);

}  // namespace lumi
