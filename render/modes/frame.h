#pragma once

#include <optional>
#include <string>

#include "calib/capture/image.h"

namespace lumi {

/// How a frame is drawn.
enum class RenderMode {
    kLightField,  ///< The paper without geometry: the scene is a plane through its centre.
    kPerPixel,    ///< Depth, weights and visibility at each pixel.
};

/// What is shown instead of the picture.
enum class DebugPicture { kNone, kWeights, kFaces, kDepth, kConfidence };

[[nodiscard]] std::string name_of(RenderMode mode);
[[nodiscard]] std::optional<RenderMode> render_mode_named(const std::string& name);
[[nodiscard]] std::string name_of(DebugPicture picture);
[[nodiscard]] std::optional<DebugPicture> debug_picture_named(const std::string& name);

struct RenderOptions {
    RenderMode mode = RenderMode::kPerPixel;
    DebugPicture debug_picture = DebugPicture::kNone;
    bool correct_occlusion = true;        ///< The paper's redistribution of weights.
    double occlusion_tolerance_px = 1.0;  ///< Disparity beyond which a view sees something else.
};

/// What was drawn.
struct Frame {
    ColorImage color;
    /// 255 where the picture is known, 0 where it is not: there it is black, or, where a camera may
    /// see something but nobody knows how far, a guess on the scene plane.
    GrayImage coverage;
};

}  // namespace lumi
