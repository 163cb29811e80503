#include "render/viewer/window_picture.h"

#include <epoxy/gl.h>

#include "calib/work/stopwatch.h"
#include "render/lumigraph/same_eye.h"
#include "render/paths/photograph_eye.h"

namespace lumi {
namespace {

bool is_same_frame(const DrawnFrame& a, const DrawnFrame& b) {
    return is_same_eye(a.eye, b.eye) && a.scale == b.scale && a.options == b.options;
}

void remember_frame_time(FrameStatistics& statistics) {
    constexpr std::size_t kRemembered = 120;
    std::vector<float>& recent = statistics.recent_frames_ms;
    if (recent.size() == kRemembered) recent.erase(recent.begin());
    recent.push_back(static_cast<float>(statistics.frame_ms));
}

}  // namespace

void WindowPicture::change_to(const Lumigraph& lumigraph) {
    renderer_ = LumigraphRenderer(lumigraph);
    drawn_.reset();
}

void WindowPicture::draw_whole(const ViewerState& state, const Eigen::Vector2i& size_px,
                               FrameStatistics& statistics) {
    draw(state.navigation.eye, 1.0, size_px, state.render, statistics);
}

void WindowPicture::draw_moving(const ViewerState& state, const Eigen::Vector2i& size_px,
                                FrameStatistics& statistics) {
    if (frames_per_second_ != state.frames_per_second) {
        frames_per_second_ = state.frames_per_second;
        resolution_ = MovingResolution(frames_per_second_);
        budget_ = TriangleBudget(frames_per_second_);
    }
    RenderOptions options = state.render;
    options.smooth_silhouettes = false;
    const bool is_limited = frames_per_second_ > 0 && options.mode == RenderMode::kAdaptive;
    if (is_limited) options = budget_.within(options);
    const bool is_drawn =
        draw(state.navigation.eye, resolution_.scale_while_moving(), size_px, options, statistics);
    if (is_limited && is_drawn) budget_.measured(statistics.triangles, statistics.frame_ms);
}

bool WindowPicture::draw(const Eye& eye, double scale, const Eigen::Vector2i& size_px,
                         const RenderOptions& options, FrameStatistics& statistics) {
    const Eigen::Vector2i size =
        (scale * size_px.cast<double>()).array().round().matrix().cast<int>().cwiseMax(1);
    const DrawnFrame wanted{fitted_to(eye, size.x(), size.y()), options, scale};
    if (drawn_ && is_same_frame(*drawn_, wanted)) return false;
    const Stopwatch stopwatch;
    statistics.triangles = target_.draw(renderer_, wanted.eye, wanted.options).triangles;
    glFinish();
    statistics.frame_ms = 1000 * stopwatch.elapsed().wall_s;
    remember_frame_time(statistics);
    statistics.width_px = size.x();
    statistics.height_px = size.y();
    resolution_.measured(scale, statistics.frame_ms);
    drawn_ = wanted;
    return true;
}

}  // namespace lumi
