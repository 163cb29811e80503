#pragma once

#include <vector>

#include "render/lumigraph/lumigraph.h"
#include "render/transfer/view_geometry.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {

/// Each kind of depth has a range of the depth buffer of its own: it begins at the step times the
/// kind, and inverse depth falls from the largest that can be drawn to 0 over the width. As in
/// shaders/agreed_depth.glsl; 1 is nothing.
inline constexpr double kDepthKindStep = 0.33;
inline constexpr double kDepthKindWidth = 0.32;

/// What depths of one surface may differ by, in units of the depth buffer: with more, kinds would
/// agree with one another.
inline constexpr double kMostAgreeingDepth = 0.5 * (kDepthKindStep - kDepthKindWidth);

/// What inverse depths of one surface may differ by in the layers that are drawn for an eye:
/// agreeing_inverse_depth of the sets' views, but no more than what keeps kinds apart where layers
/// hold all that is no nearer than nearest_inverse_depth says.
[[nodiscard]] double agreeing_in_layers(const Lumigraph& lumigraph,
                                        const std::vector<ViewGeometry>& geometries,
                                        const std::vector<DepthViewSet>& sets,
                                        const Eigen::Vector3d& eye_in_world);

}  // namespace lumi
