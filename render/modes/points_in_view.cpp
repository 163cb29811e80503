#include "render/modes/points_in_view.h"

#include "render/modes/pixel_transfer.h"

namespace lumi {
namespace {

/// Opposite directions: beside the longest.
constexpr double kLeastLength = 1e-9;

}  // namespace

PointsInView::Row PointsInView::to_border_px(const Camera& camera) const {
    return x_px.min(camera.width_px - x_px).min(y_px.min(camera.height_px - y_px));
}

PointsInView seen_by(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
                     const RayPoints& points) {
    const Eigen::Matrix3Xd& from_eye = points.directions_in_world;
    const Eigen::Vector3d eye_from_view = centre_in_world(view.cam_from_world) - eye_in_world;
    const Eigen::Matrix3Xd from_view = from_eye - eye_from_view * points.inverse_depths;
    const Eigen::Matrix3Xd pixels =
        pinhole_matrix(view.camera) *
        (view.cam_from_world.rotation.toRotationMatrix() * from_view).eval();
    PointsInView seen;
    seen.x_px = pixels.row(0).array() / pixels.row(2).array();
    seen.y_px = pixels.row(1).array() / pixels.row(2).array();
    seen.are_before = pixels.row(2).array() > 0;
    const auto dot = (from_view.array() * from_eye.array()).colwise().sum().eval();
    const auto lengths =
        (from_view.colwise().norm().array() * from_eye.colwise().norm().array()).eval();
    // Twice the tangent of half the angle: nearly the angle, and no less where it is large.
    seen.angles_rad = 2 * (lengths.square() - dot.square()).max(0.0).sqrt() /
                      (lengths + dot).max(kLeastLength * lengths.maxCoeff());
    return seen;
}

}  // namespace lumi
