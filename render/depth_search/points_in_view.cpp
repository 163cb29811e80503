#include "render/depth_search/points_in_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calib/capture/calibration_matrix.h"

namespace lumi {
namespace {

/// Of the lengths, where directions are opposite.
constexpr double kLeastShare = 1e-9;

}  // namespace

PointsInView::Row PointsInView::to_border_px(const Camera& camera) const {
    return x_px.min(camera.width_px - x_px).min(y_px.min(camera.height_px - y_px));
}

PointsInView seen_by(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
                     const RayPoints& points) {
    const Eigen::Index count = points.inverse_depths.size();
    const Eigen::Vector3d eye_from_view = centre_in_world(view.cam_from_world) - eye_in_world;
    const Eigen::Matrix3d pixel_from_world =
        calibration_matrix(view.camera) * view.cam_from_world.rotation.toRotationMatrix();
    PointsInView seen{PointsInView::Row(count), PointsInView::Row(count),
                      Eigen::Array<bool, 1, Eigen::Dynamic>(count), PointsInView::Row(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector3d from_eye = points.directions_in_world.col(i);
        const Eigen::Vector3d from_view = from_eye - points.inverse_depths[i] * eye_from_view;
        const Eigen::Vector3d pixel = pixel_from_world * from_view;
        seen.x_px[i] = pixel.x() / pixel.z();
        seen.y_px[i] = pixel.y() / pixel.z();
        seen.are_before[i] = pixel.z() > 0;
        // Twice the tangent of half the angle: nearly the angle, and no less where it is large.
        const double dot = from_view.dot(from_eye);
        const double squared_lengths = from_view.squaredNorm() * from_eye.squaredNorm();
        const double lengths = std::sqrt(squared_lengths);
        seen.angles_rad[i] =
            2 * std::sqrt(std::max(0.0, squared_lengths - dot * dot)) /
            std::max({lengths + dot, kLeastShare * lengths, std::numeric_limits<double>::min()});
    }
    return seen;
}

}  // namespace lumi
