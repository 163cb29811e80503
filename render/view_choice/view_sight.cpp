#include "render/view_choice/view_sight.h"

#include <algorithm>

#include "render/transfer/scene_plane.h"
#include "render/transfer/view_geometry.h"

namespace lumi {
namespace {

/// At this angle between view and eye a view is worth half.
constexpr double kHalfWorth_rad = 0.1;

}  // namespace

SightSamples sight_samples(const Lumigraph& lumigraph, const Eye& eye,
                           const std::vector<Eigen::Vector2d>& pixels) {
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    const double near_end = scene_inverse_depths(lumigraph).near;
    const auto count = static_cast<Eigen::Index>(pixels.size());
    SightSamples samples{{Eigen::Matrix3Xd(3, 2 * count), Eigen::RowVectorXd(2 * count)},
                         Eigen::RowVectorXd(2 * count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector2d& pixel = pixels[static_cast<std::size_t>(i)];
        const double on_plane = std::max(0.0, plane.dot(pixel.homogeneous()));
        samples.points.directions_in_world.col(i) =
            eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
        samples.points.inverse_depths[i] = on_plane;
        samples.points.inverse_depths[count + i] = std::max(on_plane, near_end);
    }
    samples.points.directions_in_world.rightCols(count) =
        samples.points.directions_in_world.leftCols(count);
    samples.worth.head(count).setOnes();
    samples.worth.tail(count).setConstant(kWorthBeforePlane);
    return samples;
}

ViewSight sight_of(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
                   const RayPoints& points) {
    const PointsInView seen = seen_by(view, eye_in_world, points);
    const double sample_px =
        std::min(view.camera.width_px, view.camera.height_px) / static_cast<double>(kSightSteps);
    ViewSight sight;
    sight.inside = seen.are_before.select(
        (0.5 + 4 * seen.to_border_px(view.camera) / sample_px).max(0.0).min(1.0), 0.0);
    sight.closeness = sight.inside.array() * kHalfWorth_rad / (kHalfWorth_rad + seen.angles_rad);
    return sight;
}

}  // namespace lumi
