#pragma once

#include <vector>

#include "render/view_choice/depth_view_choice.h"

namespace lumi {

/// Settles whether what one view alone sees before all others is there or imagined, for which the
/// nearest depth that two views agree on, or else the nearest, is not enough (agreed_depth.glsl):
///
/// - Where two others agree on something behind it, but neither looks past it, it is there: the
///   column of a portico hides the floor behind it from both, and they agree on what they see
///   behind that floor. What they agree on is taken away. (Past it as far as nothing, where that is
///   what they agree on: past_sight.h.)
/// - Where no two agree, and one that sees something else surely looks past it, it is imagined, and
///   taken away itself.
///
/// `packed` holds layers of depth as DepthLayerRasters draws them for the eye, of the sets' views
/// in the strip of each set. `agreeing_depth`: what depths of one surface may differ by, in units
/// of the depth buffer.
void settle_lone_surfaces(const std::vector<LumigraphView>& views, const Eye& eye,
                          const std::vector<DepthViewSet>& sets, int layers,
                          double max_inverse_depth, float agreeing_depth,
                          std::vector<float>& packed);

}  // namespace lumi
