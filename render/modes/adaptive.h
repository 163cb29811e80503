#pragma once

#include "render/modes/adaptive_subdivision.h"
#include "render/modes/blend_painter.h"
#include "render/modes/drawing_mode.h"

namespace lumi {

/// Adaptive depth correction by the error in pixels (adaptive_subdivision.h), with occlusion
/// correction at the vertices, in one pass.
class Adaptive : public DrawingMode {
 public:
    explicit Adaptive(const UploadedLumigraph& uploaded);
    DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                        const Viewport& viewport) override;

 private:
    const UploadedLumigraph& uploaded_;
    BlendPainter blend_;
};

}  // namespace lumi
