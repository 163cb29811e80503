#pragma once

#include <vector>

#include "render/view_choice/depth_view_choice.h"

namespace lumi {

/// What one view alone sees before what two others agree on (agreed_depth.glsl, which would leave
/// it out as imagined) is there all the same where none of these two looks past it: the column of
/// a portico hides the floor behind it from both, and they agree on what they see behind that
/// floor. What they agree on is taken away there.
///
/// `packed` holds layers of depth as DepthLayerRasters draws them for the eye, of the sets' views
/// in the strip of each set. `agreeing_depth`: what depths of one surface may differ by, in units
/// of the depth buffer.
void keep_lone_surfaces(const std::vector<LumigraphView>& views, const Eye& eye,
                        const std::vector<DepthViewSet>& sets, int layers, double max_inverse_depth,
                        float agreeing_depth, std::vector<float>& packed);

}  // namespace lumi
