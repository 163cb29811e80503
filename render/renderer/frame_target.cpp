#include "render/renderer/frame_target.h"

#include "render/gl/to_glm.h"

namespace lumi {

DrawStatistics FrameTarget::draw(LumigraphRenderer& renderer, const Eye& eye,
                                 const RenderOptions& options) {
    if (eye.camera.width_px != width_px_ || eye.camera.height_px != height_px_) {
        framebuffer_.attach_color(eye.camera.width_px, eye.camera.height_px);
        width_px_ = eye.camera.width_px;
        height_px_ = eye.camera.height_px;
        supersampled_.reset();
    }
    if (!options.supersample) {
        framebuffer_.bind();
        return renderer.draw(eye, options, {0, 0, width_px_, height_px_});
    }
    if (!supersampled_) supersampled_.emplace(width_px_, height_px_);
    supersampled_->bind();
    const DrawStatistics statistics =
        renderer.draw(eye, options, {0, 0, 2 * width_px_, 2 * height_px_});
    framebuffer_.bind();
    supersampled_->halve();
    return statistics;
}

Frame FrameTarget::read() const {
    const std::vector<unsigned char> rgba = framebuffer_.read_rgba_bottom_up(width_px_, height_px_);
    Frame frame{ColorImage(width_px_, height_px_), GrayImage(width_px_, height_px_), {}};
    for (int y = 0; y < height_px_; ++y) {
        const unsigned char* texel =
            rgba.data() + 4 * static_cast<std::size_t>(framebuffer_row(y, height_px_)) *
                              static_cast<std::size_t>(width_px_);
        for (int x = 0; x < width_px_; ++x, texel += 4) {
            frame.color(x, y) = {texel[0], texel[1], texel[2]};
            frame.coverage(x, y) = texel[3];
        }
    }
    return frame;
}

void FrameTarget::show_in_window(int window_width_px, int window_height_px) const {
    framebuffer_.copy_to_window(width_px_, height_px_, window_width_px, window_height_px);
}

}  // namespace lumi
