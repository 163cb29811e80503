#include "render/reference/reference_blend.h"

#include <algorithm>

#include "render/depth_layers/depth_eye.h"
#include "render/depth_search/occlusion.h"
#include "render/faces/off_cameras.h"
#include "render/faces/shell_opacity.h"
#include "render/reference/debug_color.h"
#include "render/transfer/border_distance.h"
#include "render/uploaded/photograph_opacity.h"

namespace lumi {

ReferenceBlend::ReferenceBlend(const Lumigraph& lumigraph, const Eye& eye,
                               const RenderOptions& options,
                               const std::optional<std::vector<FacePolygon>>& polygons)
    : lumigraph_(lumigraph),
      options_(options),
      eye_in_world_(centre_in_world(eye.cam_from_world)),
      views_(lumigraph, eye, options),
      points_(lumigraph, views_.geometries(), eye, options),
      weights_(lumigraph.mesh, points_.depth() ? eye : off_cameras(lumigraph.mesh, eye), polygons),
      is_in_blocks_(points_.depth() && is_drawn_in_blocks(lumigraph, eye, options)) {}

std::optional<DrawnPixel> ReferenceBlend::at(const KnownPoint& shared,
                                             const Eigen::Vector2d& pixel) const {
    const std::optional<RayWeights> ray = weights_.at(pixel, shared.point.direction_in_world);
    if (!ray) return std::nullopt;
    return points_.depth() ? at_depth(*ray, shared, pixel) : on_plane(*ray, shared, pixel);
}

std::optional<DrawnPixel> ReferenceBlend::on_plane(const RayWeights& ray, const KnownPoint& shared,
                                                   const Eigen::Vector2d& pixel) const {
    const RayPoint point = point_of(pixel, shared);
    std::optional<std::array<double, 3>> weights =
        of_those_that_show(ray.weights, holding(ray, shared.point));
    if (weights) weights = redistributed(*weights, opacities(*weights, ray, point));
    if (!weights) return std::nullopt;
    const double fade = options_.fade_beyond_capture ? capture_fade(ray) : 1.0;
    return DrawnPixel{fade * color_of(ray, weights, shared, point, 0.0), fade};
}

std::optional<DrawnPixel> ReferenceBlend::at_depth(const RayWeights& ray, const KnownPoint& shared,
                                                   const Eigen::Vector2d& pixel) const {
    const RayPoint point = point_of(pixel, shared);
    const std::array<double, 3> seen = visibilities(ray, shared);
    std::optional<std::array<double, 3>> weights = redistributed(ray.weights, seen);
    const double occluded = weights ? occluded_share(ray.weights, seen) : 1.0;
    double counting = 1.0;
    if (weights) {
        std::array<double, 3> opaque = opacities(*weights, ray, point);
        for (double& opacity : opaque) opacity = std::max(opacity, kLeastOpacity);
        counting = counting_share(*weights, opaque, ray);
        weights = redistributed(*weights, opaque);
    }
    const bool has_depth = shared.depth.support > 0;
    if (!weights && !has_depth) return std::nullopt;
    const bool is_known = has_depth && (weights || shared.depth.kind != DepthKind::kStretched) &&
                          counting >= kLeastCounting && !shared.depth.is_behind_tears;
    const double fade = options_.fade_beyond_capture ? capture_fade(ray) : 1.0;
    return DrawnPixel{fade * color_of(ray, weights, shared, point, occluded),
                      is_known ? fade : 0.0};
}

RayPoint ReferenceBlend::point_of(const Eigen::Vector2d& pixel, const KnownPoint& shared) const {
    RayPoint point = shared.point;
    // Steep as a tear is, all of a block shows nearly the same.
    const bool is_stretched =
        shared.depth.support > 0 && shared.depth.kind == DepthKind::kStretched;
    if (!is_in_blocks_ || !is_stretched)
        point.direction_in_world = points_.direction_in_world(pixel);
    return point;
}

std::array<double, 3> ReferenceBlend::holding(const RayWeights& ray, const RayPoint& point) const {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        if (ray.weights[i] > 0 && views_.opacity(ray.view_indices[i], point) > 0) result[i] = 1;
    return result;
}

std::array<double, 3> ReferenceBlend::visibilities(const RayWeights& ray,
                                                   const KnownPoint& known) const {
    const RayPoint& point = known.point;
    std::array<double, 3> seen{};
    const bool check_depth = known.depth.support > 0 && options_.correct_occlusion;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(ray.weights[i] > 0)) continue;
        const int view = ray.view_indices[i];
        if (check_depth)
            seen[i] = views_.visibility(view, point, known.of_views);
        else if (views_.is_inside(view, point))
            seen[i] = 1;
        if (known.depth.support == 0 && views_.is_guess_hidden(view, point)) seen[i] = 0;
    }
    if (known.depth.support == 0) leave_to_those_that_see_past(ray, point, seen);
    return seen;
}

void ReferenceBlend::leave_to_those_that_see_past(const RayWeights& ray, const RayPoint& guess,
                                                  std::array<double, 3>& seen) const {
    std::array<double, 3> past = seen;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(past[i] > 0) || !views_.sees_past_guess(ray.view_indices[i], guess)) past[i] = 0;
        sum += ray.weights[i] * past[i];
    }
    if (sum >= kLeastWeight) seen = past;
}

std::array<double, 3> ReferenceBlend::opacities(const std::array<double, 3>& weights,
                                                const RayWeights& ray,
                                                const RayPoint& point) const {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > 0) result[i] = views_.opacity(ray.view_indices[i], point) / 255;
    return result;
}

double ReferenceBlend::counting_share(const std::array<double, 3>& weights,
                                      const std::array<double, 3>& opaque,
                                      const RayWeights& ray) const {
    double counting = 0;
    for (std::size_t i = 0; i < 3; ++i)
        counting +=
            weights[i] * (opaque[i] + (views_.is_where_the_eye_is(ray.view_indices[i]) ? 1 : 0));
    return counting;
}

Eigen::Vector3d ReferenceBlend::color_of(RayWeights ray,
                                         const std::optional<std::array<double, 3>>& weights,
                                         const KnownPoint& shared, const RayPoint& point,
                                         double occluded) const {
    ray.weights = weights.value_or(std::array<double, 3>{});
    if (options_.debug_picture != DebugPicture::kNone)
        return debug_color_of(ray, !weights, shared, occluded);
    return weights ? blended(ray, point) : views_.color(point.known_by, point);
}

Eigen::Vector3d ReferenceBlend::blended(const RayWeights& ray, const RayPoint& point) const {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        if (ray.weights[i] > 0) color += ray.weights[i] * views_.color(ray.view_indices[i], point);
    return color;
}

void ReferenceBlend::lay_over(DrawnPixel& drawn, const CameraMesh& shell,
                              const KnownPoint& known) const {
    const RayPoint& point = known.point;
    const ConsensusDepth& depth = known.depth;
    const std::optional<RayWeights> ray =
        weights_of_ray(shell, eye_in_world_, point.direction_in_world);
    if (!ray || (points_.depth() && depth.support == 0)) return;
    std::array<double, 3> seen = points_.depth() ? visibilities(*ray, known) : holding(*ray, point);
    const double occluded = points_.depth() ? occluded_share(ray->weights, seen) : 0.0;
    const std::array<double, 3> opaque = opacities(ray->weights, *ray, point);
    for (std::size_t i = 0; i < 3; ++i) seen[i] *= opaque[i];
    const auto weights = redistributed(ray->weights, seen);
    if (!weights) return;
    double sum = 0;
    double inside = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto sight = views_.sight(ray->view_indices[i], point);
        if (!sight || !(ray->weights[i] > 0)) continue;
        const Camera& camera = camera_of(ray->view_indices[i]);
        sum += ray->weights[i] * seen[i];
        inside += ray->weights[i] *
                  inner_share(border_distance_px(sight->pixel, camera.width_px, camera.height_px),
                              std::min(camera.width_px, camera.height_px));
    }
    const double opacity = shell_opacity(capture_fade(*ray, kShellFadedShare), sum, inside);
    const Eigen::Vector3d color = color_of(*ray, weights, known, point, occluded);
    drawn.color = opacity * color + (1 - opacity) * drawn.color;
    drawn.coverage = opacity + (1 - opacity) * drawn.coverage;
}

Eigen::Vector3d ReferenceBlend::debug_color_of(const RayWeights& ray, bool unseen,
                                               const KnownPoint& known, double occluded) const {
    return debug_color(options_.debug_picture,
                       {ray.weights, ray.view_indices, ray.face_index, unseen,
                        known.point.inverse_depth, confidence_of(known.depth), occluded},
                       scene_inverse_depths(lumigraph_));
}

}  // namespace lumi
