#include "render/transfer/past_sight.h"

#include "meshing/surface/depth_map.h"

namespace lumi {

bool is_agreed_on(const DepthMap& depth, int x, int y) {
    return depth.confidence(x, y) == kConfirmedBySeveral && depth.inverse_depth(x, y) > 0;
}

PastSight::PastSight(const LumigraphView& view, const Eye& eye)
    : samples_from_eye_(warp_from(eye).to(view)), depth_(&view.depth) {
    const Eigen::Vector3d samples_per_pixel(
        static_cast<double>(view.depth.inverse_depth.width()) / view.camera.width_px,
        static_cast<double>(view.depth.inverse_depth.height()) / view.camera.height_px, 1.0);
    samples_from_eye_.infinite_homography =
        samples_per_pixel.asDiagonal() * samples_from_eye_.infinite_homography;
    samples_from_eye_.epipole = samples_per_pixel.cwiseProduct(samples_from_eye_.epipole);
}

Past PastSight::past(const Eigen::Vector2d& pixel, double inverse_depth, double least_difference,
                     double nearest_seen) const {
    const auto at = samples_from_eye_.at(pixel, inverse_depth);
    if (!at) return Past::kNot;
    const double x = at->pixel.x();
    const double y = at->pixel.y();
    const FloatImage& seen = depth_->inverse_depth;
    if (!(x >= 0 && y >= 0 && x < seen.width() && y < seen.height())) return Past::kNot;
    const int column = static_cast<int>(x);
    const int row = static_cast<int>(y);
    const double seen_from_eye = at->depth_ratio * static_cast<double>(seen(column, row));
    if (inverse_depth - seen_from_eye <= least_difference || seen_from_eye > nearest_seen)
        return Past::kNot;
    return is_agreed_on(*depth_, column, row) ? Past::kSurely : Past::kPerhaps;
}

}  // namespace lumi
