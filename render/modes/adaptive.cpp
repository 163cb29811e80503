#include "render/modes/adaptive.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "render/lumigraph/same_eye.h"
#include "render/subdivision/own_surfaces.h"
#include "render/subdivision/unseen_triangles.h"
#include "render/surroundings/empty_cells.h"
#include "render/surroundings/triangle_surroundings.h"
#include "render/transfer/scene_plane.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {
namespace {

/// Views that see most of what the eye sees; some may be named twice.
std::array<int, 3> three_depth_views(const Lumigraph& layout, const Eye& eye) {
    const std::vector<int> chosen = choose_depth_views(layout, eye, 3);
    return {chosen[0], chosen[std::min<std::size_t>(1, chosen.size() - 1)], chosen.back()};
}

/// Without the triangles that nothing is seen of.
BlendTriangles without_unseen(BlendTriangles triangles) {
    std::vector<std::uint32_t> seen;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const auto first = triangles.indices.begin() + static_cast<std::ptrdiff_t>(i);
        const bool is_seen = std::any_of(first, first + 3, [&](std::uint32_t vertex) {
            return triangles.vertices[vertex].opacity > 0;
        });
        if (is_seen) seen.insert(seen.end(), first, first + 3);
    }
    triangles.indices = std::move(seen);
    return triangles;
}

}  // namespace

std::vector<BlendTriangles> adaptive_layers(const Lumigraph& layout, const SearchedViews& views,
                                            const Eye& eye, const RenderOptions& options,
                                            AdaptiveSubdivider& subdivider) {
    const DepthSearch search(layout, views, eye, options.occlusion_tolerance_px);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(layout, eye);
    PatchSampler::Options sampling = sampling_options(options);
    const auto subdivided = [&](const CameraMesh& mesh, double overlap_px) {
        return subdivider
            .subdivide(face_polygons(mesh, eye, overlap_px), search, plane, sampling,
                       subdivision_options(layout, options))
            .triangles;
    };
    std::vector<BlendTriangles> layers{subdivided(layout.mesh, kOverlap_px)};
    draw_unseen(layout, eye, search, plane, sampling, layers.front());
    keep_own_surfaces(search, layers.front());
    if (layout.mesh.shells.empty()) return layers;
    sampling.before_shell = three_depth_views(layout, eye);
    for (const CameraMesh& shell : layout.mesh.shells)
        layers.push_back(without_unseen(subdivided(shell, kNoOverlap_px)));
    return layers;
}

std::vector<BlendTriangles> adaptive_layers(const Lumigraph& layout, const SearchedViews& views,
                                            const Eye& eye, const RenderOptions& options) {
    AdaptiveSubdivider subdivider;
    return adaptive_layers(layout, views, eye, options, subdivider);
}

Adaptive::Adaptive(const UploadedLumigraph& uploaded)
    : uploaded_(uploaded), surroundings_(uploaded), blend_(uploaded, kLeastConfidence) {}

bool Adaptive::is_made_for(const Eye& eye, const RenderOptions& options) const {
    if (!made_for_) return false;
    const auto wishes = [](const RenderOptions& of) {
        return std::tuple(of.correct_occlusion, of.occlusion_tolerance_px, of.fade_beyond_capture,
                          of.triangle_error_ratio, of.min_triangle_px, of.max_triangle_px,
                          of.max_triangles);
    };
    return is_same_eye(eye, made_for_->eye) && wishes(options) == wishes(made_for_->options);
}

DrawStatistics Adaptive::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    if (!is_made_for(eye, options)) {
        made_for_.reset();
        layers_ =
            adaptive_layers(uploaded_.layout, uploaded_.searched_views, eye, options, subdivider_);
        made_for_ = Request{eye, options};
    }
    const bool has_surroundings = are_surroundings_drawn(options);
    if (has_surroundings) draw_surroundings(eye);
    DrawStatistics statistics;
    Behind behind = options.fade_beyond_capture ? Behind::kPicture
                    : has_surroundings          ? Behind::kSurroundings
                                                : Behind::kNothing;
    for (const BlendTriangles& layer : layers_) {
        blend_.draw(layer, eye, options, behind);
        statistics.triangles += layer.count();
        behind = Behind::kPicture;
    }
    return statistics;
}

/// Beyond the mesh they are drawn, within it the triangles know them.
void Adaptive::draw_surroundings(const Eye& eye) {
    PictureCells cells(eye.camera);
    mark_beyond_mesh(uploaded_.layout.mesh, eye, cells);
    surroundings_.draw(cells, eye);
    set_surroundings(uploaded_.layout, uploaded_.small_photographs, eye, layers_.front());
}

}  // namespace lumi
