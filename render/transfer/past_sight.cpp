#include "render/transfer/past_sight.h"

#include <cstdint>

namespace lumi {

bool is_agreed_on(const DepthMap& depth, int x, int y) {
    constexpr std::uint8_t kBySeveral = 255;
    return depth.confidence(x, y) == kBySeveral && depth.inverse_depth(x, y) > 0;
}

PastSight::PastSight(const LumigraphView& view, const Eye& eye)
    : samples_from_eye_(
          pixel_transfer(view.camera, view.cam_from_world, eye.camera, eye.cam_from_world)),
      depth_(&view.depth) {
    const Eigen::Vector3d samples_per_pixel(
        static_cast<double>(view.depth.inverse_depth.width()) / view.camera.width_px,
        static_cast<double>(view.depth.inverse_depth.height()) / view.camera.height_px, 1.0);
    samples_from_eye_.at_infinity = samples_per_pixel.asDiagonal() * samples_from_eye_.at_infinity;
    samples_from_eye_.per_inverse_depth =
        samples_per_pixel.cwiseProduct(samples_from_eye_.per_inverse_depth);
}

Past PastSight::past(const Eigen::Vector2d& pixel, double inverse_depth, double least_difference,
                     double nearest_seen) const {
    const Eigen::Vector3d at = samples_from_eye_.at(pixel, inverse_depth);
    if (at.z() <= 0) return Past::kNot;
    const double x = at.x() / at.z();
    const double y = at.y() / at.z();
    const FloatImage& seen = depth_->inverse_depth;
    if (!(x >= 0 && y >= 0 && x < seen.width() && y < seen.height())) return Past::kNot;
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const double seen_from_eye = at.z() * static_cast<double>(seen(column, row));
    if (inverse_depth - seen_from_eye <= least_difference || seen_from_eye > nearest_seen)
        return Past::kNot;
    return is_agreed_on(*depth_, column, row) ? Past::kSurely : Past::kPerhaps;
}

}  // namespace lumi
