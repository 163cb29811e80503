#pragma once

#include <array>

#include "render/subdivision/subdivision.h"

namespace lumi {

/// Which photographs of a triangle are not to be blended, of the three that its face has.
///
/// Between the corners of a triangle weights are interpolated, and so a photograph from which
/// something hides a corner would still show, over half of the triangle, what hides it: a ghost
/// beside every outline. Where another photograph counts at all corners it is left out instead, if
/// it has seen something so far before the corner that it is no error of depth; or between the
/// corners, if it sees thin things (SearchedViews::thin). Photographs agree on what all of them
/// see, so that they may end at an edge. Corners are as they were looked up.
[[nodiscard]] std::array<bool, 3> hidden_photographs(
    const PatchSampler& sampler, const std::array<const BlendVertex*, 3>& corners);

/// The corner without these photographs: the others keep their ratio, as in the paper's correction
/// of occlusion (occlusion.h); as it is where none of the others counts there.
[[nodiscard]] BlendVertex without(const std::array<bool, 3>& photographs, BlendVertex corner);

}  // namespace lumi
