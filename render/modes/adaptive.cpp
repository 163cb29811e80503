#include "render/modes/adaptive.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "render/faces/face_polygons.h"
#include "render/lumigraph/same_eye.h"
#include "render/subdivision/own_surfaces.h"
#include "render/subdivision/seen_parts.h"
#include "render/subdivision/thin_triangles.h"
#include "render/subdivision/unseen_triangles.h"
#include "render/surroundings/empty_cells.h"
#include "render/surroundings/triangle_surroundings.h"
#include "render/transfer/polygon_extent.h"
#include "render/transfer/scene_plane.h"
#include "render/uploaded/photograph_lod.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {
namespace {

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

/// Of the mesh, which cover the picture, and of each of its shells.
std::vector<std::vector<FacePolygon>> polygons_of_layers(const CameraMesh& mesh, const Eye& eye) {
    std::vector<std::vector<FacePolygon>> layers{face_polygons(mesh, eye, kOverlap_px)};
    for (const CameraMesh& shell : mesh.shells)
        layers.push_back(face_polygons(shell, eye, kNoOverlap_px));
    return layers;
}

/// Whose photographs any of the polygons may show.
std::vector<int> views_of(const std::vector<std::vector<FacePolygon>>& layers) {
    std::set<int> views;
    for (const std::vector<FacePolygon>& polygons : layers)
        for (const FacePolygon& polygon : polygons)
            views.insert(polygon.view_indices.begin(), polygon.view_indices.end());
    return {views.begin(), views.end()};
}

double covered_px2(const std::vector<FacePolygon>& polygons) {
    double sum = 0;
    for (const FacePolygon& polygon : polygons) sum += area_px2(polygon.corners_px);
    return sum;
}

/// Of a number of triangles that may be drawn, where 0 stands for any number.
std::size_t half_of(std::size_t most) { return (most + 1) / 2; }
std::size_t rest_of(std::size_t most, std::size_t drawn) {
    return most == 0 ? 0 : std::max<std::size_t>(1, most - std::min(most, drawn));
}

/// How many of all triangles that may be drawn each layer may have: as its share of what all of
/// them cover. 0: any number.
std::vector<std::size_t> most_of_layers(const std::vector<std::vector<FacePolygon>>& layers,
                                        std::size_t most) {
    std::vector<double> areas_px2;
    for (const std::vector<FacePolygon>& layer : layers) areas_px2.push_back(covered_px2(layer));
    const double whole_px2 = std::accumulate(areas_px2.begin(), areas_px2.end(), 0.0);
    std::vector<std::size_t> shares;
    for (const double area : areas_px2) {
        const auto share =
            static_cast<std::size_t>(area / std::max(whole_px2, 1.0) * static_cast<double>(most));
        shares.push_back(most == 0 ? 0 : std::max<std::size_t>(1, share));
    }
    return shares;
}

}  // namespace

std::vector<BlendTriangles> adaptive_layers(const Lumigraph& layout, const SearchedViews& views,
                                            const Eye& eye, const RenderOptions& options,
                                            AdaptiveSubdivider& subdivider) {
    const DepthSearch search(layout, views, eye);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(layout, eye);
    const std::vector<std::vector<FacePolygon>> polygons = polygons_of_layers(layout.mesh, eye);
    const OutlineCells outlines(layout, views, views_of(polygons), eye);
    const auto subdivided = [&](const std::vector<FacePolygon>& of_layer,
                                const PatchSampler::Options& sampling, std::size_t most) {
        AdaptiveSubdivisionOptions subdivision = subdivision_options(layout, options);
        subdivision.max_triangles = most;
        return subdivider.subdivide(of_layer, search, plane, sampling, subdivision, outlines)
            .triangles;
    };
    BlendTriangles thin;
    if (layout.drawing.draws_thin && !options.fade_beyond_capture)
        thin = thin_triangles(layout, views, eye, search, half_of(options.max_triangles));
    std::vector<std::size_t> most =
        most_of_layers(polygons, rest_of(options.max_triangles, thin.count()));
    std::vector<BlendTriangles> layers(polygons.size());
    PatchSampler::Options sampling = sampling_options(options);
    if (layers.size() > 1)
        sampling.before_shell = three_with_repeats(choose_depth_views(layout, eye, 3));
    for (std::size_t shell = 1; shell < layers.size(); ++shell) {
        layers[shell] = without_unseen(subdivided(polygons[shell], sampling, most[shell]));
        // What it does not need is the mesh's.
        if (most[shell] > 0) most[0] += most[shell] - std::min(most[shell], layers[shell].count());
    }
    sampling.before_shell.reset();
    layers[0] = subdivided(polygons[0], sampling, most[0]);
    const std::vector<UnseenTriangle> partly_seen =
        draw_unseen(layout, eye, search, plane, sampling, layers[0]);
    // Guesses are not laid over anything, nor is what fades: what it fades over would show through.
    BlendTriangles parts;
    const bool has_room = most[0] == 0 || layers[0].count() < most[0];
    if (search.has_depth() && !options.fade_beyond_capture && has_room)
        parts = seen_parts(partly_seen, layers[0].vertices, {search, plane, sampling},
                           {.long_edge_px = 2 * subdivision_options(layout, options).min_edge_px,
                            .max_parts = rest_of(most[0], layers[0].count())});
    keep_own_surfaces(search, layers[0]);
    if (thin.count() > 0) layers.insert(layers.begin() + 1, std::move(thin));
    if (parts.count() > 0) layers.insert(layers.begin() + 1, std::move(parts));
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
    return made_for_ && is_same_eye(eye, made_for_->eye) && options == made_for_->options;
}

DrawStatistics Adaptive::draw(const Eye& eye, const RenderOptions& options, const Viewport&) {
    if (!is_made_for(eye, options)) {
        made_for_.reset();
        layers_ =
            adaptive_layers(uploaded_.layout, uploaded_.searched_views, eye, options, subdivider_);
        made_for_ = Request{eye, options};
    }
    const bool has_surroundings = are_surroundings_drawn(options);
    if (has_surroundings) draw_surroundings(eye, options);
    DrawStatistics statistics;
    Behind behind = options.fade_beyond_capture ? Behind::kBlack
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
void Adaptive::draw_surroundings(const Eye& eye, const RenderOptions& options) {
    PictureCells cells(eye.camera);
    mark_beyond_mesh(uploaded_.layout.mesh, eye, cells);
    surroundings_.draw(cells, eye);
    set_surroundings(uploaded_.layout, uploaded_.small_photographs, eye, layers_.front(),
                     unsure_border_px(uploaded_.lod_of(eye, options)));
}

}  // namespace lumi
