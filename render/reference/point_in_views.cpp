#include "render/reference/point_in_views.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "render/depth_search/occlusion.h"
#include "render/transfer/border_distance.h"
#include "render/transfer/sampling.h"
#include "render/uploaded/photograph_opacity.h"

namespace lumi {
namespace {

/// The inverse depth of what a view knows nothing of. As in shaders/agreed_depth.glsl.
constexpr double kNowhere = -1e9;

}  // namespace

PointInViews::PointInViews(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options)
    : lumigraph_(lumigraph),
      options_(options),
      eye_in_world_(centre_in_world(eye.cam_from_world)),
      geometries_(view_geometries(lumigraph)),
      photographs_(lumigraph, eye, photograph_opacities(lumigraph)) {}

std::optional<Sight> PointInViews::sight(int view_index, const RayPoint& point) const {
    const LumigraphView& seen_by = view(view_index);
    // Scaled by the inverse depth, so that a point at infinity is a direction.
    const Eigen::Vector3d in_view = seen_by.cam_from_world.rotation * point.direction_in_world +
                                    point.inverse_depth * (seen_by.cam_from_world * eye_in_world_);
    const auto pixel = project(seen_by.camera, in_view);
    if (!pixel) return std::nullopt;
    return Sight{*pixel, point.inverse_depth / in_view.z(), in_view.z()};
}

bool PointInViews::is_inside(int view_index, const RayPoint& point) const {
    const std::optional<Sight> at = sight(view_index, point);
    const Camera& camera = view(view_index).camera;
    return at && border_distance_px(at->pixel, camera.width_px, camera.height_px) >= 0;
}

double PointInViews::seen_by(int view_index, const Sight& sight,
                             const std::map<int, EyeDepth>& asked) const {
    const auto said = asked.find(view_index);
    if (said != asked.end()) {
        const EyeDepth& depth = said->second;
        const bool is_seen = depth.is_known() && depth.kind != DepthKind::kStretched;
        return (is_seen ? depth.inverse_depth : kNowhere) / sight.depth_ratio;
    }
    const Camera& camera = view(view_index).camera;
    const FloatImage& depth = view(view_index).depth.inverse_depth;
    return nearest(depth, {sight.pixel.x() * depth.width() / camera.width_px,
                           sight.pixel.y() * depth.height() / camera.height_px});
}

double PointInViews::visibility(int view_index, const RayPoint& point,
                                const std::map<int, EyeDepth>& asked) const {
    if (!is_inside(view_index, point)) return 0;
    const Sight at = *sight(view_index, point);
    const double difference_px =
        std::abs(at.inverse_depth - seen_by(view_index, at, asked)) *
        disparity_px_per_inverse_depth(geometries_[static_cast<std::size_t>(view_index)],
                                       eye_in_world_);
    return visibility_of(difference_px, lumigraph_.drawing.occlusion_tolerance_px);
}

bool PointInViews::is_guess_hidden(int view_index, const RayPoint& point) const {
    if (!checks_guess_in(view_index, point)) return false;
    const Sight at = *sight(view_index, point);
    const double before_px = (seen_by(view_index, at, {}) - at.inverse_depth) *
                             disparity_px_per_inverse_depth(
                                 geometries_[static_cast<std::size_t>(view_index)], eye_in_world_);
    return before_px > kSurelyBefore_px;
}

bool PointInViews::sees_past_guess(int view_index, const RayPoint& point) const {
    return checks_guess_in(view_index, point) &&
           seen_by(view_index, *sight(view_index, point), {}) == 0;
}

bool PointInViews::checks_guess_in(int view_index, const RayPoint& point) const {
    return lumigraph_.drawing.checks_guesses && view(view_index).has_depth() &&
           is_inside(view_index, point);
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
    return disparity_px * scene_inverse_depths(lumigraph_).near <= kMostParallax_px;
}

}  // namespace lumi
