#include "render/transfer/past_sight.h"

namespace lumi {

PastSight::PastSight(const LumigraphView& view, const Eye& eye)
    : samples_from_eye_(
          pixel_transfer(view.camera, view.cam_from_world, eye.camera, eye.cam_from_world)),
      inverse_depth_(&view.depth.inverse_depth) {
    const Eigen::Vector3d samples_per_pixel(
        static_cast<double>(inverse_depth_->width()) / view.camera.width_px,
        static_cast<double>(inverse_depth_->height()) / view.camera.height_px, 1.0);
    samples_from_eye_.at_infinity = samples_per_pixel.asDiagonal() * samples_from_eye_.at_infinity;
    samples_from_eye_.per_inverse_depth =
        samples_per_pixel.cwiseProduct(samples_from_eye_.per_inverse_depth);
}

bool PastSight::is_past(const Eigen::Vector2d& pixel, double inverse_depth,
                        double least_difference) const {
    const Eigen::Vector3d at = samples_from_eye_.at(pixel, inverse_depth);
    if (at.z() <= 0) return false;
    const double x = at.x() / at.z();
    const double y = at.y() / at.z();
    if (!(x >= 0 && y >= 0 && x < inverse_depth_->width() && y < inverse_depth_->height()))
        return false;
    const double seen =
        at.z() * static_cast<double>((*inverse_depth_)(static_cast<int>(x), static_cast<int>(y)));
    return inverse_depth - seen > least_difference;
}

}  // namespace lumi
