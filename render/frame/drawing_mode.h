#pragma once

#include "render/frame/frame.h"
#include "render/frame/viewport.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// One way of drawing a Lumigraph into the bound framebuffer.
class DrawingMode {
 public:
    virtual ~DrawingMode() = default;
    /// The eye has the viewport's size; the viewport is set and cleared.
    virtual DrawStatistics draw(const Eye& eye, const RenderOptions& options,
                                const Viewport& viewport) = 0;
    /// Drops what is kept from frame to frame while the eye stands still.
    virtual void forget_frame() {}
};

}  // namespace lumi
