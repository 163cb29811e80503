#include "render/reference/reference_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <vector>

#include "calib/capture/nearest_byte.h"
#include "meshing/surface/camera_mesh.h"
#include "render/depth_layers/depth_eye.h"
#include "render/depth_search/occlusion.h"
#include "render/faces/off_cameras.h"
#include "render/faces/shell_opacity.h"
#include "render/reference/debug_color.h"
#include "render/reference/known_points.h"
#include "render/reference/pixel_weights.h"
#include "render/reference/point_in_views.h"
#include "render/reference/reference_holes.h"
#include "render/surroundings/surroundings.h"
#include "render/transfer/border_distance.h"
#include "render/uploaded/photograph_opacity.h"

namespace lumi {
namespace {

struct DrawnPixel {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    double coverage = 0.0;  ///< 0 for a guess.
};

/// The frame in the making, and what does not change from pixel to pixel.
class ReferenceFrame {
 public:
    ReferenceFrame(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options,
                   const std::optional<std::vector<FacePolygon>>& polygons);
    [[nodiscard]] DrawnPixel color_at(int x, int y) const;

 private:
    /// The mean of all that is drawn for a pixel.
    [[nodiscard]] std::optional<DrawnPixel> base_at(const std::vector<KnownPoint>& shared,
                                                    const Eigen::Vector2d& pixel) const;
    /// `shared` is what the fragment of a pixel is drawn for, its centre or that of its block.
    [[nodiscard]] std::optional<DrawnPixel> base_at(const KnownPoint& shared,
                                                    const Eigen::Vector2d& pixel) const;
    /// Where nothing is seen.
    [[nodiscard]] DrawnPixel behind(int x, int y) const;
    /// What is not known is drawn from other views, if these know it.
    void fill(DrawnPixel& drawn, int x, int y) const;
    void lay_over(DrawnPixel& drawn, const CameraMesh& shell, const KnownPoint& known) const;
    [[nodiscard]] std::array<double, 3> visibilities(const RayWeights& ray,
                                                     const KnownPoint& known) const;
    /// Of a guess, where any views see past it.
    void leave_to_those_that_see_past(const RayWeights& ray, const RayPoint& guess,
                                      std::array<double, 3>& seen) const;
    [[nodiscard]] std::array<double, 3> opacities(const std::array<double, 3>& weights,
                                                  const RayWeights& ray,
                                                  const RayPoint& point) const;
    [[nodiscard]] Eigen::Vector3d blended(const RayWeights& ray, const RayPoint& point) const;
    [[nodiscard]] Eigen::Vector3d debug_color_of(const RayWeights& ray, bool unseen,
                                                 const KnownPoint& known, double occluded) const;
    [[nodiscard]] const Camera& camera_of(int view) const {
        return lumigraph_.views[static_cast<std::size_t>(view)].camera;
    }

    const Lumigraph& lumigraph_;
    const RenderOptions& options_;
    Eigen::Vector3d eye_in_world_;
    PointInViews views_;
    KnownPoints points_;
    PixelWeights weights_;
    bool is_in_blocks_;
    ColorImage surroundings_;      ///< Empty where they are not drawn.
    std::optional<Frame> filled_;  ///< None where holes are not filled.
};

ReferenceFrame::ReferenceFrame(const Lumigraph& lumigraph, const Eye& eye,
                               const RenderOptions& options,
                               const std::optional<std::vector<FacePolygon>>& polygons)
    : lumigraph_(lumigraph),
      options_(options),
      eye_in_world_(centre_in_world(eye.cam_from_world)),
      views_(lumigraph, eye, options),
      points_(lumigraph, views_.geometries(), eye, options),
      weights_(lumigraph.mesh, points_.depth() ? eye : off_cameras(lumigraph.mesh, eye), polygons),
      is_in_blocks_(points_.depth() && is_drawn_in_blocks(lumigraph, eye, options)),
      surroundings_(
          are_surroundings_drawn(options)
              ? surroundings_picture(lumigraph, eye, is_in_blocks_ ? kDepthBlockSide_px : 1)
              : ColorImage{}) {
    if (points_.depth() && lumigraph.drawing.fills_holes && !options.fade_beyond_capture)
        filled_ = filled_holes(lumigraph, *points_.depth(), eye, options);
}

std::array<double, 3> ReferenceFrame::visibilities(const RayWeights& ray,
                                                   const KnownPoint& known) const {
    const RayPoint& point = known.point;
    std::array<double, 3> seen{};
    const bool check_depth = known.depth.support > 0 && options_.correct_occlusion;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(ray.weights[i] > 0)) continue;
        const int view = ray.view_indices[i];
        if (check_depth)
            seen[i] = views_.visibility(view, point, known.of_views);
        else if (points_.depth() ? views_.is_inside(view, point) : views_.opacity(view, point) > 0)
            seen[i] = 1;
        if (points_.depth() && known.depth.support == 0 && views_.is_guess_hidden(view, point))
            seen[i] = 0;
    }
    if (points_.depth() && known.depth.support == 0) leave_to_those_that_see_past(ray, point, seen);
    return seen;
}

void ReferenceFrame::leave_to_those_that_see_past(const RayWeights& ray, const RayPoint& guess,
                                                  std::array<double, 3>& seen) const {
    std::array<double, 3> past = seen;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!(past[i] > 0) || !views_.sees_past_guess(ray.view_indices[i], guess)) past[i] = 0;
        sum += ray.weights[i] * past[i];
    }
    if (sum >= kLeastWeight) seen = past;
}

std::array<double, 3> ReferenceFrame::opacities(const std::array<double, 3>& weights,
                                                const RayWeights& ray,
                                                const RayPoint& point) const {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > 0) result[i] = views_.opacity(ray.view_indices[i], point) / 255;
    return result;
}

Eigen::Vector3d ReferenceFrame::blended(const RayWeights& ray, const RayPoint& point) const {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        if (ray.weights[i] > 0) color += ray.weights[i] * views_.color(ray.view_indices[i], point);
    return color;
}

std::optional<DrawnPixel> ReferenceFrame::base_at(const std::vector<KnownPoint>& shared,
                                                  const Eigen::Vector2d& pixel) const {
    if (shared.size() == 1) return base_at(shared.front(), pixel);
    DrawnPixel sum;
    double count = 0;
    for (const KnownPoint& known : shared) {
        const std::optional<DrawnPixel> drawn = base_at(known, pixel);
        if (!drawn) continue;
        sum.color += drawn->color;
        sum.coverage += drawn->coverage;
        ++count;
    }
    if (count == 0) return std::nullopt;
    return DrawnPixel{sum.color / count, sum.coverage >= 0.5 * count ? 1.0 : 0.0};
}

std::optional<DrawnPixel> ReferenceFrame::base_at(const KnownPoint& shared,
                                                  const Eigen::Vector2d& pixel) const {
    const ConsensusDepth& depth = shared.depth;
    std::optional<RayWeights> ray = weights_.at(pixel, shared.point.direction_in_world);
    if (!ray) return std::nullopt;
    const bool has_depth = depth.support > 0;
    const std::array<double, 3> seen = visibilities(*ray, shared);
    RayPoint point = shared.point;
    // Steep as a tear is, all of a block shows nearly the same.
    const bool is_stretched = has_depth && depth.kind == DepthKind::kStretched;
    if (!is_in_blocks_ || !is_stretched)
        point.direction_in_world = points_.direction_in_world(pixel);
    std::optional<std::array<double, 3>> weights = points_.depth()
                                                       ? redistributed(ray->weights, seen)
                                                       : of_those_that_show(ray->weights, seen);
    const double occluded = !points_.depth() ? 0.0
                            : weights        ? occluded_share(ray->weights, seen)
                                             : 1.0;
    double counting = weights ? 0.0 : 1.0;
    if (weights) {
        std::array<double, 3> opaque = opacities(*weights, *ray, point);
        if (points_.depth())
            for (double& opacity : opaque) opacity = std::max(opacity, kLeastOpacity);
        for (std::size_t i = 0; i < 3; ++i)
            counting += (*weights)[i] *
                        (opaque[i] + (views_.is_where_the_eye_is(ray->view_indices[i]) ? 1 : 0));
        weights = redistributed(*weights, opaque);
    }
    if (!weights && !has_depth) return std::nullopt;
    const double fade = options_.fade_beyond_capture ? capture_fade(*ray) : 1.0;
    DrawnPixel drawn;
    const bool is_known =
        has_depth && (weights || depth.kind != DepthKind::kStretched) && counting >= kLeastCounting;
    drawn.coverage = is_known || !points_.depth() ? fade : 0.0;
    ray->weights = weights.value_or(std::array<double, 3>{});
    if (options_.debug_picture != DebugPicture::kNone)
        drawn.color = fade * debug_color_of(*ray, !weights, shared, occluded);
    else if (weights)
        drawn.color = fade * blended(*ray, point);
    else
        drawn.color = fade * views_.color(point.known_by, point);
    return drawn;
}

void ReferenceFrame::lay_over(DrawnPixel& drawn, const CameraMesh& shell,
                              const KnownPoint& known) const {
    const RayPoint& point = known.point;
    const ConsensusDepth& depth = known.depth;
    std::optional<RayWeights> ray = weights_of_ray(shell, eye_in_world_, point.direction_in_world);
    if (!ray || (points_.depth() && depth.support == 0)) return;
    std::array<double, 3> seen = visibilities(*ray, known);
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
    ray->weights = *weights;
    const Eigen::Vector3d color = options_.debug_picture != DebugPicture::kNone
                                      ? debug_color_of(*ray, false, known, occluded)
                                      : blended(*ray, point);
    drawn.color = opacity * color + (1 - opacity) * drawn.color;
    drawn.coverage = opacity + (1 - opacity) * drawn.coverage;
}

DrawnPixel ReferenceFrame::color_at(int x, int y) const {
    const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
    const Eigen::Vector2d block(x / kDepthBlockSide_px, y / kDepthBlockSide_px);
    const std::vector<KnownPoint> known = points_.at(pixel);
    DrawnPixel drawn =
        base_at(is_in_blocks_
                    ? points_.at(kDepthBlockSide_px * (block + Eigen::Vector2d::Constant(0.5)))
                    : known,
                pixel)
            .value_or(behind(x, y));
    fill(drawn, x, y);
    // What the paper of heigl says has none.
    if (options_.mode == RenderMode::kHeigl) return drawn;
    for (const CameraMesh& shell : lumigraph_.mesh.shells) lay_over(drawn, shell, known.front());
    return drawn;
}

DrawnPixel ReferenceFrame::behind(int x, int y) const {
    DrawnPixel drawn;
    if (surroundings_.empty()) return drawn;
    const Rgb8& color = surroundings_(x, y);
    drawn.color = {static_cast<double>(color.r), static_cast<double>(color.g),
                   static_cast<double>(color.b)};
    return drawn;
}

void ReferenceFrame::fill(DrawnPixel& drawn, int x, int y) const {
    if (!filled_ || filled_->coverage(x, y) == 0) return;
    // White among the weights: none of those that should see it does.
    const Rgb8 color = options_.debug_picture == DebugPicture::kWeights ? Rgb8{255, 255, 255}
                                                                        : filled_->color(x, y);
    drawn.color = (1 - drawn.coverage) * Eigen::Vector3d(color.r, color.g, color.b) +
                  drawn.coverage * drawn.color;
    drawn.coverage = std::max(drawn.coverage, filled_->coverage(x, y) / 255.0);
}

Eigen::Vector3d ReferenceFrame::debug_color_of(const RayWeights& ray, bool unseen,
                                               const KnownPoint& known, double occluded) const {
    return debug_color(options_.debug_picture,
                       {ray.weights, ray.view_indices, ray.face_index, unseen,
                        known.point.inverse_depth, confidence_of(known.depth), occluded},
                       inverse_depth_range(lumigraph_));
}

}  // namespace

Frame draw_reference(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options,
                     const std::optional<std::vector<FacePolygon>>& polygons) {
    const ReferenceFrame reference(lumigraph, eye, options, polygons);
    Frame frame = empty_frame(eye.camera);
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const DrawnPixel drawn = reference.color_at(x, y);
            const Eigen::Vector3d& color = drawn.color;
            frame.color(x, y) = {nearest_byte(color.x()), nearest_byte(color.y()),
                                 nearest_byte(color.z())};
            frame.coverage(x, y) = nearest_byte(255 * drawn.coverage);
        }
    }
    return frame;
}

}  // namespace lumi
