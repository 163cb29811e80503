#pragma once

#include <optional>

#include "render/frame/frame.h"
#include "render/gl/framebuffer.h"
#include "render/painters/supersampled_target.h"
#include "render/renderer/lumigraph_renderer.h"

namespace lumi {

/// The raster that a frame is drawn into before it becomes a file or a window: the same 8-bit RGBA
/// for both, so that both hold the same picture. The context that made it must be current.
class FrameTarget {
 public:
    /// Draws a frame of the eye's size.
    DrawStatistics draw(LumigraphRenderer& renderer, const Eye& eye, const RenderOptions& options);
    /// The frame that was drawn last.
    [[nodiscard]] Frame read() const;
    /// Scales that frame to the window, whose framebuffer is bound afterwards.
    void show_in_window(int window_width_px, int window_height_px) const;

 private:
    Framebuffer framebuffer_;
    std::optional<SupersampledTarget> supersampled_;
    int width_px_ = 0;
    int height_px_ = 0;
};

}  // namespace lumi
