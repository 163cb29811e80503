#include "render/subdivision/patch_sampler.h"

#include <algorithm>
#include <utility>

#include "render/depth_search/occlusion.h"
#include "render/faces/shell_opacity.h"

namespace lumi {

PatchSampler::Options sampling_options(const RenderOptions& options) {
    return {.correct_occlusion = options.correct_occlusion,
            .fade_beyond_border = options.fade_beyond_capture,
            .before_shell = {}};
}

PatchSampler::PatchSampler(const FacePolygon& polygon, const DepthSearch& search,
                           const Eigen::Vector3d& scene_plane, const Options& options)
    : polygon_(polygon), search_(search), scene_plane_(scene_plane), options_(options) {}

/// The views of the face, those that count most first: faces that share an edge ask the same views
/// there.
std::array<int, 3> PatchSampler::by_weight(const std::array<double, 3>& weights) const {
    std::array<std::size_t, 3> order{0, 1, 2};
    const auto in_order = [&](std::size_t before, std::size_t after) {
        if (weights[order[before]] < weights[order[after]]) std::swap(order[before], order[after]);
    };
    in_order(0, 1);
    in_order(1, 2);
    in_order(0, 1);
    return {polygon_.view_indices[order[0]], polygon_.view_indices[order[1]],
            polygon_.view_indices[order[2]]};
}

/// Meshes of a line name a view twice.
std::size_t PatchSampler::first_of_same_view(std::size_t k) const {
    const std::array<int, 3>& views = polygon_.view_indices;
    return static_cast<std::size_t>(std::find(views.begin(), views.end(), views[k]) -
                                    views.begin());
}

/// A shell's views may not see what stands between it and the eye.
std::optional<RayHit> PatchSampler::first_hit(const PatchSample& sample) const {
    const auto hit = search_.first_hit(sample.pixel, by_weight(sample.ray_weights));
    if (!hit || !options_.before_shell) return hit;
    const auto before = search_.first_hit(sample.pixel, *options_.before_shell);
    return before && before->kind == DepthKind::kSeen && search_.is_before(*before, *hit) ? before
                                                                                          : hit;
}

/// Where the ray meets the scene. The paper leaves open where a vertex lies whose ray does not: on
/// the scene plane.
void PatchSampler::correct_depth(const std::optional<RayHit>& hit, PatchSample& sample) const {
    sample.hits = hit.has_value();
    sample.inverse_depth =
        hit ? hit->inverse_depth : std::max(0.0, scene_plane_.dot(sample.pixel.homogeneous()));
    sample.depth = 1 / std::max(sample.inverse_depth, search_.least_inverse_depth());
    if (hit)
        sample.confidence = hit->kind == DepthKind::kSeen
                                ? static_cast<double>(kSeenByOne) * std::min(2, hit->support)
                                : static_cast<double>(kFilledConfidence);
}

/// Where the photographs show the point.
void PatchSampler::look_up(PatchSample& sample) const {
    double ratio = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto in_view =
            search_.line_in(polygon_.view_indices[k], sample.pixel).at(sample.inverse_depth);
        if (!in_view) continue;
        sample.view_pixels[k] = in_view->pixel;
        sample.depth_ratios[k] = in_view->depth_ratio;
        ratio += sample.ray_weights[k] * in_view->depth_ratio;
    }
    if (ratio > 0) sample.affine_depth = 1 / ratio;
}

/// A guess is nothing that stands before it.
bool PatchSampler::is_guess_hidden(const PatchSample& sample, int view) const {
    return !sample.hits && !options_.by_the_paper &&
           search_.hidden_by_px(sample.pixel, sample.inverse_depth, view) >= kSurelyBefore_px;
}

/// How far each view sees the point.
std::array<double, 3> PatchSampler::visibilities(const std::optional<RayHit>& hit,
                                                 const PatchSample& sample) const {
    std::array<double, 3> visible{};
    for (std::size_t k = 0; k < 3; ++k) {
        if (sample.depth_ratios[k] <= 0) continue;
        if (const std::size_t same = first_of_same_view(k); same < k) {
            visible[k] = visible[same];
            continue;
        }
        const int view = polygon_.view_indices[k];
        const bool may_be_hidden = hit && options_.correct_occlusion && !hit->is_met_by(view);
        visible[k] = may_be_hidden ? search_.visibility(sample.pixel, hit->inverse_depth, view)
                     : is_guess_hidden(sample, view) ? 0.0
                                                     : search_.inside(view, sample.view_pixels[k]);
    }
    return visible;
}

/// The weights of what is seen. Where nothing is, it is a guess: the ray's weights in the
/// photographs that hold the point.
void PatchSampler::correct_occlusion(const std::array<double, 3>& visible,
                                     PatchSample& sample) const {
    if (options_.by_the_paper) {
        const std::array<bool, 3> sees{visible[0] > 0, visible[1] > 0, visible[2] > 0};
        sample.occluded = occluded_share(
            sample.ray_weights, {sees[0] ? 1.0 : 0.0, sees[1] ? 1.0 : 0.0, sees[2] ? 1.0 : 0.0});
        sample.weights = redistributed_by_the_paper(sample.ray_weights, sees);
        if (sample.weights == std::array<double, 3>{}) sample.confidence = 0;
        return;
    }
    sample.occluded = occluded_share(sample.ray_weights, visible);
    if (const auto weights = redistributed(sample.ray_weights, visible)) {
        sample.weights = *weights;
        return;
    }
    sample.confidence = 0;
    if (!sample.hits) return;
    std::array<double, 3> inside{};
    for (std::size_t k = 0; k < 3; ++k)
        if (sample.depth_ratios[k] > 0)
            inside[k] = search_.inside(polygon_.view_indices[k], sample.view_pixels[k]);
    sample.weights = redistributed(sample.ray_weights, inside).value_or(std::array<double, 3>{});
}

double PatchSampler::opacity_of(const PatchSample& sample,
                                const std::array<double, 3>& visible) const {
    RayWeights ray{polygon_.face_index, polygon_.view_indices, sample.ray_weights, 0.0};
    for (std::size_t k = 0; k < 3; ++k)
        ray.beyond_border += sample.ray_weights[k] * static_cast<double>(polygon_.beyond_border[k]);
    if (!options_.before_shell) return options_.fade_beyond_border ? capture_fade(ray) : 1.0;
    if (!sample.hits) return 0.0;
    double seen = 0;
    double inside = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (sample.depth_ratios[k] <= 0) continue;
        seen += sample.ray_weights[k] * visible[k];
        inside += sample.ray_weights[k] *
                  search_.inner_share_of(polygon_.view_indices[k], sample.view_pixels[k]);
    }
    return shell_opacity(capture_fade(ray, kShellFadedShare), seen, inside);
}

PatchSample PatchSampler::at(const Eigen::Vector2d& pixel) const {
    PatchSample sample;
    sample.pixel = pixel;
    sample.ray_weights = weights_at(polygon_, pixel);
    const std::optional<RayHit> hit = first_hit(sample);
    correct_depth(hit, sample);
    look_up(sample);
    const std::array<double, 3> visible = visibilities(hit, sample);
    correct_occlusion(visible, sample);
    sample.opacity = opacity_of(sample, visible);
    return sample;
}

}  // namespace lumi
