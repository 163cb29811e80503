#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What LumigraphRenderer draws, in plain code and without OpenGL, in any mode: what its frames are
/// compared with. Slow. Throws Error (E-RENDER-REFERENCE) for what plain code does not draw: four
/// samples a pixel, and grids.
[[nodiscard]] Frame draw_mode_reference(const Lumigraph& lumigraph, const Eye& eye,
                                        const RenderOptions& options);

}  // namespace lumi
