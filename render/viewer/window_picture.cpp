#include "render/viewer/window_picture.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "calib/work/stopwatch.h"
#include "render/gl/capabilities.h"
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

int most_side_px() {
    const Capabilities capabilities = query_capabilities();
    return std::min(capabilities.max_renderbuffer_size_px, capabilities.max_texture_size_px);
}

/// The part of the eye's picture that is shown enlarged, as a picture of the same size.
Eye enlarged(Eye eye, const Enlargement& enlargement) {
    if (enlargement.times == 1.0) return eye;
    const Eigen::Vector2d focal = enlargement.times * focal_length_px(eye.camera);
    const Eigen::Vector2d size(eye.camera.width_px, eye.camera.height_px);
    const Eigen::Vector2d centre = enlargement.place(principal_point_px(eye.camera), size);
    eye.camera.parameters = {focal.x(), focal.y(), centre.x(), centre.y()};
    return eye;
}

}  // namespace

WindowPicture::WindowPicture(const Lumigraph& lumigraph)
    : renderer_(lumigraph), most_side_px_(most_side_px()) {}

void WindowPicture::change_to(const Lumigraph& lumigraph) {
    renderer_ = LumigraphRenderer(lumigraph);
    drawn_.reset();
    resolution_.begin_anew();
}

void WindowPicture::heed_what_costs(const RenderOptions& options, const Eigen::Vector2i& size_px) {
    if (measured_options_ == options && measured_size_px_ == size_px) return;
    measured_options_ = options;
    measured_size_px_ = size_px;
    resolution_.begin_anew();
}

void WindowPicture::draw_whole(const ViewerState& state, const Eigen::Vector2i& size_px,
                               FrameStatistics& statistics) {
    heed_what_costs(state.render, size_px);
    if (draw(state, 1.0, size_px, state.render, statistics))
        resolution_.guessed(1.0, statistics.frame_ms);
}

void WindowPicture::draw_moving(const ViewerState& state, const Eigen::Vector2i& size_px,
                                FrameStatistics& statistics) {
    if (frames_per_second_ != state.frames_per_second) {
        frames_per_second_ = state.frames_per_second;
        resolution_ = MovingResolution(frames_per_second_);
        budget_ = TriangleBudget(frames_per_second_);
    }
    heed_what_costs(state.render, size_px);
    RenderOptions options = state.render;
    options.smooth_silhouettes = false;
    const bool is_limited = frames_per_second_ > 0 && options.mode == RenderMode::kAdaptive;
    if (is_limited) options = budget_.within(options);
    const double scale = resolution_.scale_while_moving();
    const bool is_drawn = draw(state, scale, size_px, options, statistics);
    if (is_drawn) resolution_.measured(scale, statistics.frame_ms);
    if (is_limited && is_drawn) budget_.measured(statistics.triangles, statistics.frame_ms);
}

bool WindowPicture::draw(const ViewerState& state, double scale, const Eigen::Vector2i& size_px,
                         const RenderOptions& options, FrameStatistics& statistics) {
    const double drawable = std::min(1.0, static_cast<double>(most_side_px_) / size_px.maxCoeff());
    const Eigen::Vector2i size = (scale * drawable * size_px.cast<double>())
                                     .array()
                                     .round()
                                     .matrix()
                                     .cast<int>()
                                     .cwiseMax(1);
    const Eye eye =
        enlarged(fitted_to(state.navigation.eye, size.x(), size.y()), state.enlargement);
    const DrawnFrame wanted{eye, options, scale};
    if (drawn_ && is_same_frame(*drawn_, wanted)) return false;
    const Stopwatch stopwatch;
    statistics.triangles = target_.draw(renderer_, wanted.eye, wanted.options).triangles;
    glFinish();
    statistics.frame_ms = 1000 * stopwatch.elapsed().wall_s;
    remember_frame_time(statistics);
    statistics.width_px = size.x();
    statistics.height_px = size.y();
    drawn_ = wanted;
    return true;
}

}  // namespace lumi
