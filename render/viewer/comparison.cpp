#include "render/viewer/comparison.h"

#include <epoxy/gl.h>

#include "render/paths/photograph_eye.h"
#include "render/viewer/difference_picture.h"

namespace lumi {
namespace {

ObjectName<delete_texture> uploaded(const ColorImage& picture) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, picture.width(), picture.height(), 0, GL_RGB,
                 GL_UNSIGNED_BYTE, picture.pixels().data());
    glGenerateMipmap(GL_TEXTURE_2D);
    return ObjectName<delete_texture>(name);
}

}  // namespace

PictureOverlay fitted_overlay(const Eye& eye, int width_px, int height_px,
                              const Enlargement& enlargement) {
    const Eigen::Vector2d frame(width_px, height_px);
    const Camera fitted = fitted_to(eye, width_px, height_px).camera;
    const double scale = fitting_scale(eye, width_px, height_px);
    const Eigen::Vector2d corner =
        principal_point_px(fitted) - scale * principal_point_px(eye.camera);
    const Eigen::Vector2d size = scale * Eigen::Vector2d(eye.camera.width_px, eye.camera.height_px);
    const Eigen::Vector2d low = enlargement.place(corner, frame);
    const Eigen::Vector2d extent = enlargement.times * size;
    PictureOverlay overlay;
    overlay.low_px = low.cwiseMax(0.0).cwiseMin(frame);
    overlay.high_px = (low + extent).cwiseMin(frame).cwiseMax(0.0);
    overlay.texture_low = (overlay.low_px - low).cwiseQuotient(extent);
    overlay.texture_high = (overlay.high_px - low).cwiseQuotient(extent);
    return overlay;
}

std::optional<PictureOverlay> Comparison::over_frame(const ViewerState& state, int width_px,
                                                     int height_px, LumigraphRenderer& renderer) {
    if (!is_compared(views_, state)) return std::nullopt;
    const HeldOutView& view = views_[static_cast<std::size_t>(state.compared_index)];
    Shown wanted{state.compared_index, state.shows_difference, state.render};
    wanted.options.debug_picture = DebugPicture::kNone;
    if (wanted != shown_) {
        target_.draw(renderer, view.eye, wanted.options);
        const Frame drawn = target_.read();
        texture_ = uploaded(wanted.is_difference ? difference_picture(drawn.color, view.photograph)
                                                 : view.photograph);
        likeness_ = likeness_words_ ? likeness_words_(drawn, view) : "";
        shown_ = wanted;
    }
    PictureOverlay overlay = fitted_overlay(view.eye, width_px, height_px, state.enlargement);
    overlay.texture = texture_.get();
    overlay.share = state.shows_difference ? 1.0 : state.compared_share;
    overlay.likeness = likeness_;
    return overlay;
}

}  // namespace lumi
