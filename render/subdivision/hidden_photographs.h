#pragma once

#include <array>

#include "render/subdivision/patch_sampler.h"

namespace lumi {

/// Which photographs of a triangle are not to be blended, of the three that its face has.
///
/// Weights are interpolated across a triangle, and so a photograph from which something hides a
/// corner would still show, over half of the triangle, what hides it: a ghost beside every outline.
/// Where another photograph counts at all corners, the hidden one is left out instead if it saw
/// something too far before a corner to be an error of depth; or, if it sees thin things
/// (SearchedViews::thin), between the corners. Photographs agree on what all of them see, so that
/// they may end at an edge. Corners are as they were looked up.
[[nodiscard]] std::array<bool, 3> hidden_photographs(
    const PatchSampler& sampler, const std::array<const BlendVertex*, 3>& corners);

/// The corner without these photographs: the others keep their ratio, as in the paper's correction
/// of occlusion (occlusion.h); as it is where none of the others counts there.
[[nodiscard]] BlendVertex without(const std::array<bool, 3>& photographs, BlendVertex corner);

}  // namespace lumi
