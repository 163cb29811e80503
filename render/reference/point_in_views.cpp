#include "render/reference/point_in_views.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/modes/occlusion.h"
#include "render/modes/photograph_opacity.h"
#include "render/reference/sampling.h"

namespace lumi {

double border_distance_px(const Camera& camera, const Eigen::Vector2d& pixel) {
    return std::min(
        {pixel.x(), pixel.y(), camera.width_px - pixel.x(), camera.height_px - pixel.y()});
}

PointInViews::PointInViews(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options)
    : lumigraph_(lumigraph),
      options_(options),
      eye_in_world_(centre_in_world(eye.cam_from_world)),
      geometries_(view_geometries(lumigraph)),
      photographs_(lumigraph, eye) {}

std::optional<Sight> PointInViews::sight(int view_index, const RayPoint& point) const {
    const LumigraphView& seen_by = view(view_index);
    // Scaled by the inverse depth, so that a point at infinity is a direction.
    const Eigen::Vector3d in_view = seen_by.cam_from_world.rotation * point.direction_in_world +
                                    point.inverse_depth * (seen_by.cam_from_world * eye_in_world_);
    const auto pixel = project(seen_by.camera, in_view);
    if (!pixel) return std::nullopt;
    return Sight{*pixel, point.inverse_depth / in_view.z()};
}

double PointInViews::visibility(int view_index, const RayPoint& point, bool check_depth) const {
    const std::optional<Sight> seen = sight(view_index, point);
    if (!seen) return 0;
    const LumigraphView& seen_by = view(view_index);
    const bool is_inside = border_distance_px(seen_by.camera, seen->pixel) >= 0;
    if (!check_depth || !is_inside) return is_inside ? 1 : 0;
    const FloatImage& depth = seen_by.depth.inverse_depth;
    const Eigen::Vector2d in_depth_map(seen->pixel.x() * depth.width() / seen_by.camera.width_px,
                                       seen->pixel.y() * depth.height() / seen_by.camera.height_px);
    const double difference_px =
        std::abs(seen->inverse_depth - nearest(depth, in_depth_map)) *
        disparity_px_per_inverse_depth(geometries_[static_cast<std::size_t>(view_index)],
                                       eye_in_world_);
    return visibility_of(difference_px, options_.occlusion_tolerance_px);
}

double PointInViews::opacity(int view_index, const RayPoint& point) const {
    const std::optional<Sight> seen = sight(view_index, point);
    return seen ? photographs_.opacity(view_index, seen->pixel) : 0.0;
}

Eigen::Vector3d PointInViews::color(int view_index, const RayPoint& point) const {
    const std::optional<Sight> seen = sight(view_index, point);
    return seen ? photographs_.color(view_index, seen->pixel) : Eigen::Vector3d::Zero();
}

bool PointInViews::is_where_the_eye_is(int view_index) const {
    const double disparity_px = disparity_px_per_inverse_depth(
        geometries_[static_cast<std::size_t>(view_index)], eye_in_world_);
    return disparity_px * inverse_depth_range(lumigraph_).y() <= kMostParallax_px;
}

}  // namespace lumi
