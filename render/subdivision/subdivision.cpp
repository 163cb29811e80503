#include "render/subdivision/subdivision.h"

#include <algorithm>
#include <utility>

#include "render/depth_search/occlusion.h"
#include "render/faces/shell_opacity.h"

namespace lumi {

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

/// A shell's views may not see what stands between it and the eye.
std::optional<RayHit> PatchSampler::first_hit(const PatchSample& sample) const {
    const auto hit = search_.first_hit(sample.pixel, by_weight(sample.ray_weights));
    if (!hit || !options_.before_shell) return hit;
    const auto before = search_.first_hit(sample.pixel, *options_.before_shell);
    return before && before->kind == DepthKind::kSeen && search_.is_before(*before, *hit) ? before
                                                                                          : hit;
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

/// A guess is nothing that stands before it.
bool PatchSampler::is_guess_hidden(const PatchSample& sample, int view) const {
    return !sample.hits && !options_.unseen_is_black &&
           search_.hidden_by_px(sample.pixel, sample.inverse_depth, view) >= kSurelyBefore_px;
}

PatchSample PatchSampler::at(const Eigen::Vector2d& pixel) const {
    PatchSample sample;
    sample.pixel = pixel;
    sample.ray_weights = weights_at(polygon_, pixel);
    const std::optional<RayHit> hit = first_hit(sample);
    sample.hits = hit.has_value();
    sample.inverse_depth =
        hit ? hit->inverse_depth : std::max(0.0, scene_plane_.dot(pixel.homogeneous()));
    sample.depth = 1 / std::max(sample.inverse_depth, search_.least_inverse_depth());
    if (hit)
        sample.confidence = hit->kind == DepthKind::kSeen ? 0.5 * std::min(2, hit->support) : 0.25;
    std::array<double, 3> visible{};
    double ratio = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const int view = polygon_.view_indices[k];
        const auto same = static_cast<std::size_t>(
            std::find(polygon_.view_indices.begin(), polygon_.view_indices.end(), view) -
            polygon_.view_indices.begin());
        if (same < k) {  // Meshes of a line name a view twice.
            sample.view_pixels[k] = sample.view_pixels[same];
            sample.depth_ratios[k] = sample.depth_ratios[same];
            ratio += sample.ray_weights[k] * sample.depth_ratios[k];
            visible[k] = visible[same];
            continue;
        }
        const Eigen::Vector3d in_view = search_.line_in(view, pixel).at(sample.inverse_depth);
        if (in_view.z() <= 0) continue;
        sample.view_pixels[k] = in_view.hnormalized();
        sample.depth_ratios[k] = in_view.z();
        ratio += sample.ray_weights[k] * in_view.z();
        const bool may_be_hidden = hit && options_.correct_occlusion && !hit->is_met_by(view);
        visible[k] = may_be_hidden ? search_.visibility(pixel, hit->inverse_depth, view)
                     : is_guess_hidden(sample, view) ? 0.0
                                                     : search_.inside(view, sample.view_pixels[k]);
    }
    sample.occluded = 1;
    for (std::size_t k = 0; k < 3; ++k) sample.occluded -= sample.ray_weights[k] * visible[k];
    if (ratio > 0) sample.affine_depth = 1 / ratio;
    sample.opacity = opacity_of(sample, visible);
    if (const auto weights = redistributed(sample.ray_weights, visible)) {
        sample.weights = *weights;
        return sample;
    }
    sample.confidence = 0;
    if (options_.unseen_is_black || !hit) return sample;
    std::array<double, 3> inside{};
    for (std::size_t k = 0; k < 3; ++k)
        if (sample.depth_ratios[k] > 0)
            inside[k] = search_.inside(polygon_.view_indices[k], sample.view_pixels[k]);
    sample.weights = redistributed(sample.ray_weights, inside).value_or(std::array<double, 3>{});
    return sample;
}

BlendVertex blend_vertex(const PatchSample& sample, const FacePolygon& polygon, VertexDepth depth) {
    BlendVertex corner;
    corner.pixel = {static_cast<float>(sample.pixel.x()), static_cast<float>(sample.pixel.y())};
    corner.depth =
        static_cast<float>(depth == VertexDepth::kTrue ? sample.depth : sample.affine_depth);
    for (std::size_t k = 0; k < 3; ++k) {
        corner.view_pixels[k] = {static_cast<float>(sample.view_pixels[k].x()),
                                 static_cast<float>(sample.view_pixels[k].y())};
        corner.weights[k] = static_cast<float>(sample.weights[k]);
        corner.view_layers[k] = static_cast<float>(polygon.view_indices[k]);
        corner.depth_ratios[k] = static_cast<float>(sample.depth_ratios[k]);
    }
    corner.inverse_depth = static_cast<float>(sample.inverse_depth);
    corner.confidence = static_cast<float>(sample.confidence);
    corner.occluded = static_cast<float>(sample.occluded);
    corner.face_index = static_cast<float>(polygon.face_index);
    corner.opacity = static_cast<float>(sample.opacity);
    return corner;
}

PatchSampler::Options sampling_options(const RenderOptions& options) {
    return {.correct_occlusion = options.correct_occlusion,
            .fade_beyond_border = options.fade_beyond_capture,
            .before_shell = {}};
}

SubdividedPatch::SubdividedPatch(const PatchSampler& sampler) : sampler_(sampler) {
    for (const Eigen::Vector2d& corner : sampler.polygon().corners_px)
        static_cast<void>(add(corner));
    corner_count_ = static_cast<std::uint32_t>(samples_.size());
}

std::uint32_t SubdividedPatch::add(const Eigen::Vector2d& pixel) {
    samples_.push_back(sampler_.at(pixel));
    return static_cast<std::uint32_t>(samples_.size() - 1);
}

std::uint32_t SubdividedPatch::midpoint(std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] = midpoints_.try_emplace(key(a, b), 0U);
    if (is_new) found->second = add(0.5 * (samples_[a].pixel + samples_[b].pixel));
    return found->second;
}

std::optional<std::uint32_t> SubdividedPatch::known_midpoint(std::uint32_t a,
                                                             std::uint32_t b) const {
    const auto found = midpoints_.find(key(a, b));
    if (found == midpoints_.end()) return std::nullopt;
    return found->second;
}

void SubdividedPatch::append_to(BlendTriangles& drawn,
                                const std::vector<std::array<std::uint32_t, 3>>& triangles,
                                VertexDepth depth) const {
    constexpr std::uint32_t kNone = 0xffffffffU;
    std::vector<std::uint32_t> index_of(samples_.size(), kNone);
    const FacePolygon& polygon = sampler_.polygon();
    for (const auto& triangle : triangles) {
        for (const std::uint32_t vertex : triangle) {
            if (index_of[vertex] == kNone) {
                index_of[vertex] = static_cast<std::uint32_t>(drawn.vertices.size());
                drawn.vertices.push_back(blend_vertex(samples_[vertex], polygon, depth));
            }
            drawn.indices.push_back(index_of[vertex]);
        }
    }
}

}  // namespace lumi
