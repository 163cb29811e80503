#include "render/reference/reference_renderer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include "meshing/surface/camera_mesh.h"
#include "render/modes/depth_eye.h"
#include "render/modes/depth_layer_views.h"
#include "render/modes/depth_view_choice.h"
#include "render/modes/occlusion.h"
#include "render/modes/photograph_layer.h"
#include "render/modes/photograph_lod.h"
#include "render/modes/photograph_opacity.h"
#include "render/modes/scene_plane.h"
#include "render/modes/shell_opacity.h"
#include "render/modes/surroundings.h"
#include "render/modes/view_depth_mesh.h"
#include "render/modes/view_geometry.h"
#include "render/reference/depth_consensus.h"
#include "render/reference/depth_raster.h"
#include "render/reference/mip_levels.h"
#include "render/reference/sampling.h"

namespace lumi {
namespace {

/// A scene point on the eye's ray: eye + direction / inverse_depth, perhaps infinitely far.
struct RayPoint {
    Eigen::Vector3d direction_in_world;  ///< Of unit depth along the eye's optical axis.
    double inverse_depth = 0.0;
    int known_by = kNoView;  ///< The first of the views whose depth says so.
};

/// A point as one view sees it.
struct Sight {
    Eigen::Vector2d pixel;
    double inverse_depth = 0.0;
};

double border_distance_px(const Camera& camera, const Eigen::Vector2d& pixel) {
    return std::min(
        {pixel.x(), pixel.y(), camera.width_px - pixel.x(), camera.height_px - pixel.y()});
}

struct DrawnPixel {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    double coverage = 0.0;  ///< 0 for a guess.
};

/// The frame in the making, and what does not change from pixel to pixel.
class ReferenceFrame {
 public:
    ReferenceFrame(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options);
    [[nodiscard]] DrawnPixel color_at(int x, int y) const;

 private:
    void draw_depth_layers();
    void make_mip_levels();
    [[nodiscard]] Eigen::Vector4d at_mip_level(int view_index, const Eigen::Vector2d& pixel) const;
    [[nodiscard]] const std::vector<int>& depth_views_at(int x) const;
    [[nodiscard]] ConsensusDepth depth_at(int x, int y) const;
    [[nodiscard]] std::optional<DrawnPixel> base_at(const RayPoint& point,
                                                    const ConsensusDepth& depth) const;
    /// Where nothing is seen.
    [[nodiscard]] DrawnPixel behind(int x, int y) const;
    void lay_over(DrawnPixel& drawn, const CameraMesh& shell, const RayPoint& point,
                  const ConsensusDepth& depth) const;
    [[nodiscard]] std::array<double, 3> visibilities(const RayWeights& ray, const RayPoint& point,
                                                     const ConsensusDepth& depth) const;
    [[nodiscard]] std::array<double, 3> opacities(const std::array<double, 3>& weights,
                                                  const RayWeights& ray,
                                                  const RayPoint& point) const;
    [[nodiscard]] Eigen::Vector3d blended(const RayWeights& ray, const RayPoint& point) const;
    [[nodiscard]] std::optional<Sight> sight_of(int view_index, const RayPoint& point) const;
    [[nodiscard]] bool is_where_the_eye_is(int view_index) const;
    [[nodiscard]] double visibility(int view_index, const RayPoint& point, bool check_depth) const;
    /// How much its photograph counts there, 0 to 255.
    [[nodiscard]] double opacity(int view_index, const RayPoint& point) const;
    [[nodiscard]] Eigen::Vector3d color_in(int view_index, const RayPoint& point) const;
    [[nodiscard]] Eigen::Vector3d debug_color(const RayWeights& ray, bool unseen,
                                              const ConsensusDepth& depth, double occluded) const;

    /// Of the depth that is drawn for the eye: the column or row that a pixel lies in.
    [[nodiscard]] int texel(int pixel) const {
        return static_cast<int>((pixel + 0.5) * depth_eye_.texels_per_pixel);
    }

    [[nodiscard]] const LumigraphView& view(int index) const {
        return lumigraph_.views[static_cast<std::size_t>(index)];
    }

    const Lumigraph& lumigraph_;
    const Eye& eye_;
    const RenderOptions& options_;
    bool uses_depth_;
    Eigen::Vector3d eye_in_world_;
    Eigen::Vector3d plane_;
    std::vector<ViewGeometry> geometries_;
    std::vector<GrayImage> opacities_;
    double lod_;
    Eigen::Vector2d layer_size_px_ = Eigen::Vector2d::Zero();
    std::vector<MipLevels> mip_levels_;  ///< Of the photographs; without at the finest level.
    DepthEye depth_eye_;
    std::vector<DepthViewSet> depth_views_;
    std::vector<int> strip_ends_;
    DepthLayerViews layer_views_;
    double agreeing_inverse_depth_ = 0.0;
    std::map<int, Image<EyeDepth>> eye_depth_of_view_;
    ColorImage surroundings_;  ///< Empty where they are not drawn.
};

/// Of a ray's weight, what views do not see.
double occluded_share(const RayWeights& ray, const std::array<double, 3>& seen) {
    double lost = 1;
    for (std::size_t i = 0; i < 3; ++i) lost -= ray.weights[i] * seen[i];
    return lost;
}

bool has_depth(const Lumigraph& lumigraph) {
    return std::any_of(lumigraph.views.begin(), lumigraph.views.end(),
                       [](const auto& view) { return !view.depth.inverse_depth.empty(); });
}

ReferenceFrame::ReferenceFrame(const Lumigraph& lumigraph, const Eye& eye,
                               const RenderOptions& options)
    : lumigraph_(lumigraph),
      eye_(eye),
      options_(options),
      uses_depth_(options.mode == RenderMode::kPerPixel && has_depth(lumigraph)),
      eye_in_world_(centre_in_world(eye.cam_from_world)),
      plane_(scene_plane_inverse_depth(lumigraph, eye)),
      geometries_(view_geometries(lumigraph)),
      opacities_(photograph_opacities(lumigraph)),
      lod_(photograph_lod(lumigraph, eye)),
      depth_eye_(depth_eye(lumigraph, eye, options)),
      surroundings_(are_surroundings_drawn(options) ? surroundings_picture(lumigraph, eye)
                                                    : ColorImage{}) {
    if (lod_ > 0) make_mip_levels();
    if (uses_depth_) draw_depth_layers();
}

/// Of layers as large as the largest photograph, as they are uploaded.
void ReferenceFrame::make_mip_levels() {
    Eigen::Vector2i size(1, 1);
    for (const LumigraphView& view : lumigraph_.views)
        size = size.cwiseMax(Eigen::Vector2i(view.photograph.width(), view.photograph.height()));
    size += Eigen::Vector2i::Constant(2 * kGutter_px);
    layer_size_px_ = size.cast<double>();
    for (std::size_t i = 0; i < opacities_.size(); ++i)
        mip_levels_.emplace_back(
            photograph_layer(lumigraph_.views[i].photograph, opacities_[i], size.x(), size.y()),
            size.x(), size.y());
}

Eigen::Vector4d ReferenceFrame::at_mip_level(int view_index, const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d texel = pixel + Eigen::Vector2d::Constant(kGutter_px);
    return mip_levels_[static_cast<std::size_t>(view_index)].at(texel.cwiseQuotient(layer_size_px_),
                                                                lod_);
}

void ReferenceFrame::draw_depth_layers() {
    depth_views_ = depth_view_sets(lumigraph_, eye_, lumigraph_.depth_views);
    strip_ends_ = strip_ends(depth_views_, depth_eye_.eye.camera.width_px);
    layer_views_ = depth_layer_views(depth_views_, lumigraph_.depth_views);
    agreeing_inverse_depth_ =
        agreeing_inverse_depth(geometries_, depth_views_, options_.occlusion_tolerance_px);
    for (const DepthViewSet& set : depth_views_) {
        for (const int index : set.view_indices) {
            if (eye_depth_of_view_.contains(index)) continue;
            const ViewGeometry& geometry = geometries_[static_cast<std::size_t>(index)];
            const auto mesh = depth_mesh_of(view(index), max_disparity_px(geometry));
            eye_depth_of_view_[index] = rasterise(*mesh, view(index), depth_eye_.eye);
        }
    }
}

/// The views that are asked at a column of pixels, kNoView among them.
const std::vector<int>& ReferenceFrame::depth_views_at(int x) const {
    const auto end = std::upper_bound(strip_ends_.begin(), strip_ends_.end(), texel(x));
    return layer_views_[static_cast<std::size_t>(end - strip_ends_.begin())];
}

/// Without any support: the scene plane, for the mode that draws it or as a guess.
ConsensusDepth ReferenceFrame::depth_at(int x, int y) const {
    ConsensusDepth depth;
    if (uses_depth_) {
        std::vector<EyeDepth> depths;
        for (const int index : depth_views_at(x))
            depths.push_back(index == kNoView ? EyeDepth{}
                                              : eye_depth_of_view_.at(index)(texel(x), texel(y)));
        depth = consensus_of(depths, agreeing_inverse_depth_);
    }
    if (depth.support == 0)
        depth.inverse_depth = std::max(0.0, plane_.dot(Eigen::Vector3d(x + 0.5, y + 0.5, 1)));
    return depth;
}

std::optional<Sight> ReferenceFrame::sight_of(int view_index, const RayPoint& point) const {
    const LumigraphView& seen_by = view(view_index);
    // Scaled by the inverse depth, so that a point at infinity is a direction.
    const Eigen::Vector3d in_view = seen_by.cam_from_world.rotation * point.direction_in_world +
                                    point.inverse_depth * (seen_by.cam_from_world * eye_in_world_);
    const auto pixel = project(seen_by.camera, in_view);
    if (!pixel) return std::nullopt;
    return Sight{*pixel, point.inverse_depth / in_view.z()};
}

double ReferenceFrame::visibility(int view_index, const RayPoint& point, bool check_depth) const {
    const std::optional<Sight> sight = sight_of(view_index, point);
    if (!sight) return 0;
    const LumigraphView& seen_by = view(view_index);
    if (!uses_depth_) return 1;
    const bool is_inside = border_distance_px(seen_by.camera, sight->pixel) >= 0;
    if (!check_depth || !is_inside) return is_inside ? 1 : 0;
    const FloatImage& depth = seen_by.depth.inverse_depth;
    const Eigen::Vector2d in_depth_map(
        sight->pixel.x() * depth.width() / seen_by.camera.width_px,
        sight->pixel.y() * depth.height() / seen_by.camera.height_px);
    const double difference_px =
        std::abs(sight->inverse_depth - nearest(depth, in_depth_map)) *
        disparity_px_per_inverse_depth(geometries_[static_cast<std::size_t>(view_index)],
                                       eye_in_world_);
    return visibility_of(difference_px, options_.occlusion_tolerance_px);
}

double ReferenceFrame::opacity(int view_index, const RayPoint& point) const {
    const std::optional<Sight> sight = sight_of(view_index, point);
    if (sight && lod_ > 0) return at_mip_level(view_index, sight->pixel)[3];
    return sight ? bilinear_to_zero(opacities_[static_cast<std::size_t>(view_index)], sight->pixel)
                 : 0.0;
}

Eigen::Vector3d ReferenceFrame::color_in(int view_index, const RayPoint& point) const {
    const std::optional<Sight> sight = sight_of(view_index, point);
    if (sight && lod_ > 0) return at_mip_level(view_index, sight->pixel).head<3>();
    return sight ? bilinear(view(view_index).photograph, sight->pixel) : Eigen::Vector3d::Zero();
}

std::array<double, 3> ReferenceFrame::visibilities(const RayWeights& ray, const RayPoint& point,
                                                   const ConsensusDepth& depth) const {
    std::array<double, 3> seen{};
    for (std::size_t i = 0; i < 3; ++i)
        if (ray.weights[i] > 0)
            seen[i] = visibility(ray.view_indices[i], point,
                                 depth.support > 0 && options_.correct_occlusion);
    return seen;
}

std::array<double, 3> ReferenceFrame::opacities(const std::array<double, 3>& weights,
                                                const RayWeights& ray,
                                                const RayPoint& point) const {
    std::array<double, 3> result{};
    for (std::size_t i = 0; i < 3; ++i)
        if (weights[i] > 0) result[i] = opacity(ray.view_indices[i], point) / 255;
    return result;
}

Eigen::Vector3d ReferenceFrame::blended(const RayWeights& ray, const RayPoint& point) const {
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i)
        if (ray.weights[i] > 0) color += ray.weights[i] * color_in(ray.view_indices[i], point);
    return color;
}

bool ReferenceFrame::is_where_the_eye_is(int view_index) const {
    const double disparity_px = disparity_px_per_inverse_depth(
        geometries_[static_cast<std::size_t>(view_index)], eye_in_world_);
    return disparity_px * inverse_depth_range(lumigraph_).y() <= kMostParallax_px;
}

std::optional<DrawnPixel> ReferenceFrame::base_at(const RayPoint& point,
                                                  const ConsensusDepth& depth) const {
    std::optional<RayWeights> ray =
        weights_of_ray(lumigraph_.mesh, eye_in_world_, point.direction_in_world);
    if (!ray) return std::nullopt;
    const bool has_depth = depth.support > 0;
    const std::array<double, 3> seen = visibilities(*ray, point, depth);
    std::optional<std::array<double, 3>> weights = redistributed(ray->weights, seen);
    const double occluded = weights ? occluded_share(*ray, seen) : 1.0;
    double counting = weights ? 0.0 : 1.0;
    if (weights) {
        const std::array<double, 3> opaque = opacities(*weights, *ray, point);
        for (std::size_t i = 0; i < 3; ++i)
            counting +=
                (*weights)[i] * (opaque[i] + (is_where_the_eye_is(ray->view_indices[i]) ? 1 : 0));
        weights = redistributed(*weights, opaque);
    }
    if (!weights && !has_depth) return std::nullopt;
    const double fade = options_.fade_beyond_capture ? capture_fade(*ray) : 1.0;
    DrawnPixel drawn;
    const bool is_known =
        has_depth && (weights || depth.kind != DepthKind::kStretched) && counting >= kLeastCounting;
    drawn.coverage = is_known || !uses_depth_ ? fade : 0.0;
    ray->weights = weights.value_or(std::array<double, 3>{});
    if (options_.debug_picture != DebugPicture::kNone)
        drawn.color = fade * debug_color(*ray, !weights, depth, occluded);
    else if (weights)
        drawn.color = fade * blended(*ray, point);
    else
        drawn.color = fade * color_in(point.known_by, point);
    return drawn;
}

void ReferenceFrame::lay_over(DrawnPixel& drawn, const CameraMesh& shell, const RayPoint& point,
                              const ConsensusDepth& depth) const {
    std::optional<RayWeights> ray = weights_of_ray(shell, eye_in_world_, point.direction_in_world);
    if (!ray || (uses_depth_ && depth.support == 0)) return;
    std::array<double, 3> seen = visibilities(*ray, point, depth);
    const double occluded = occluded_share(*ray, seen);
    const std::array<double, 3> opaque = opacities(ray->weights, *ray, point);
    for (std::size_t i = 0; i < 3; ++i) seen[i] *= opaque[i];
    const auto weights = redistributed(ray->weights, seen);
    if (!weights) return;
    double sum = 0;
    double inside = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto sight = sight_of(ray->view_indices[i], point);
        if (!sight || !(ray->weights[i] > 0)) continue;
        const Camera& camera = view(ray->view_indices[i]).camera;
        sum += ray->weights[i] * seen[i];
        inside += ray->weights[i] * inner_share(border_distance_px(camera, sight->pixel),
                                                std::min(camera.width_px, camera.height_px));
    }
    const double opacity = shell_opacity(capture_fade(*ray, kShellFadedShare), sum, inside);
    ray->weights = *weights;
    const Eigen::Vector3d color = options_.debug_picture != DebugPicture::kNone
                                      ? debug_color(*ray, false, depth, occluded)
                                      : blended(*ray, point);
    drawn.color = opacity * color + (1 - opacity) * drawn.color;
    drawn.coverage = opacity + (1 - opacity) * drawn.coverage;
}

DrawnPixel ReferenceFrame::color_at(int x, int y) const {
    const Eigen::Vector3d direction =
        eye_.cam_from_world.rotation.conjugate() * unproject(eye_.camera, {x + 0.5, y + 0.5});
    const ConsensusDepth depth = depth_at(x, y);
    RayPoint point{direction, depth.inverse_depth};
    if (depth.support > 0)
        point.known_by = depth_views_at(x)[static_cast<std::size_t>(depth.best_layer)];
    DrawnPixel drawn = base_at(point, depth).value_or(behind(x, y));
    for (const CameraMesh& shell : lumigraph_.mesh.shells) lay_over(drawn, shell, point, depth);
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

/// A colour for an index; neighbours differ (golden ratio).
Eigen::Vector3d index_color(int index) {
    const double turn = 0.618034 * index - std::floor(0.618034 * index);
    constexpr double kFullTurn = 6.2831853;
    return 255 * (Eigen::Vector3d::Constant(0.5) +
                  0.5 * Eigen::Vector3d(std::cos(kFullTurn * turn),
                                        std::cos(kFullTurn * (turn + 1.0 / 3)),
                                        std::cos(kFullTurn * (turn + 2.0 / 3))));
}

double confidence_of(const ConsensusDepth& depth) {
    if (depth.support == 0) return 0;
    if (depth.kind == DepthKind::kSeen) return 0.5 * depth.support;
    return depth.kind == DepthKind::kFilled ? 0.25 : 0.125;
}

Eigen::Vector3d ReferenceFrame::debug_color(const RayWeights& ray, bool unseen,
                                            const ConsensusDepth& depth, double occluded) const {
    const Eigen::Vector3d white = Eigen::Vector3d::Constant(255);
    if (options_.debug_picture == DebugPicture::kFaces) return index_color(ray.face_index);
    if (options_.debug_picture == DebugPicture::kOcclusion) return occluded * white;
    if (options_.debug_picture == DebugPicture::kConfidence) return confidence_of(depth) * white;
    if (options_.debug_picture == DebugPicture::kDepth) {
        const Eigen::Vector2d range = inverse_depth_range(lumigraph_);
        const double share = (depth.inverse_depth - range.x()) / (range.y() - range.x());
        return std::clamp(share, 0.0, 1.0) * white;
    }
    if (unseen) return white;
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) color += ray.weights[i] * index_color(ray.view_indices[i]);
    return color;
}

std::uint8_t to_byte(double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

}  // namespace

Frame draw_reference(const Lumigraph& lumigraph, const Eye& eye, const RenderOptions& options) {
    const ReferenceFrame reference(lumigraph, eye, options);
    Frame frame{ColorImage(eye.camera.width_px, eye.camera.height_px),
                GrayImage(eye.camera.width_px, eye.camera.height_px),
                {}};
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const DrawnPixel drawn = reference.color_at(x, y);
            const Eigen::Vector3d& color = drawn.color;
            frame.color(x, y) = {to_byte(color.x()), to_byte(color.y()), to_byte(color.z())};
            frame.coverage(x, y) = to_byte(255 * drawn.coverage);
        }
    }
    return frame;
}

}  // namespace lumi
