#pragma once

#include <vector>

#include "render/modes/adaptive_subdivision.h"
#include "render/modes/blend_painter.h"
#include "render/modes/drawing_mode.h"

namespace lumi {

/// The triangles of the mode `adaptive` for one eye: those of the camera mesh, then those of each
/// of its shells, which are laid over with their opacity. `geometries` are the layout's.
[[nodiscard]] std::vector<BlendTriangles> adaptive_layers(
    const Lumigraph& layout, const std::vector<ViewGeometry>& geometries, const Eye& eye,
    const RenderOptions& options);

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
