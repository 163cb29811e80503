#pragma once

#include <limits>

#include "calib/capture/image.h"
#include "render/lumigraph/depth_mesh.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What a view's depth says about one pixel of the eye.
struct EyeDepth {
    double inverse_depth = -1.0;  ///< Along the eye's optical axis; negative: nothing known.
    DepthKind kind = DepthKind::kStretched;
    /// Whether it was seen behind what the view stretches over a tear (behind_tears.h).
    bool is_behind_tear = false;

    [[nodiscard]] bool is_known() const { return inverse_depth >= 0; }
};

/// A view's depth mesh as the eye sees it: at each pixel's centre the nearest surface of the most
/// reliable kind, back faces left out, and so what is nearer than `max_inverse_depth` says; what
/// was seen behind what is stretched, by more than agrees, is marked. One triangle after the other,
/// one pixel after the other.
[[nodiscard]] Image<EyeDepth> rasterise(
    const DepthMesh& mesh, const LumigraphView& view, const Eye& eye,
    double max_inverse_depth = std::numeric_limits<double>::infinity(),
    double agreeing_inverse_depth = std::numeric_limits<double>::infinity());

}  // namespace lumi
