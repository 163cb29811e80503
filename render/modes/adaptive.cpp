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

/// How many triangles may be drawn, or any number; parts of a limited number are one at least.
class TriangleAllowance {
 public:
    /// 0: any number, as everywhere.
    explicit TriangleAllowance(std::size_t most) : most_(most) {}

    [[nodiscard]] std::size_t most() const { return most_; }
    [[nodiscard]] bool is_limited() const { return most_ > 0; }
    [[nodiscard]] bool has_room_after(std::size_t drawn) const {
        return !is_limited() || drawn < most_;
    }
    [[nodiscard]] TriangleAllowance half() const { return TriangleAllowance((most_ + 1) / 2); }
    [[nodiscard]] TriangleAllowance share(double part) const {
        return at_least_one(static_cast<std::size_t>(part * static_cast<double>(most_)));
    }
    [[nodiscard]] TriangleAllowance rest_after(std::size_t drawn) const {
        return at_least_one(most_ - std::min(most_, drawn));
    }
    /// What another does not need, of which so many were drawn.
    void take_over(const TriangleAllowance& other, std::size_t drawn) {
        if (other.is_limited()) most_ += other.most_ - std::min(other.most_, drawn);
    }

 private:
    [[nodiscard]] TriangleAllowance at_least_one(std::size_t most) const {
        return TriangleAllowance(is_limited() ? std::max<std::size_t>(1, most) : 0);
    }

    std::size_t most_;
};

/// How many of all triangles that may be drawn each layer may have: as its share of what all of
/// them cover.
std::vector<TriangleAllowance> allowances_of(const std::vector<std::vector<FacePolygon>>& layers,
                                             const TriangleAllowance& all) {
    std::vector<double> areas_px2;
    for (const std::vector<FacePolygon>& layer : layers) areas_px2.push_back(covered_px2(layer));
    const double whole_px2 = std::accumulate(areas_px2.begin(), areas_px2.end(), 0.0);
    std::vector<TriangleAllowance> shares;
    for (const double area : areas_px2)
        shares.push_back(all.share(area / std::max(whole_px2, 1.0)));
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
                                const PatchSampler::Options& sampling,
                                const TriangleAllowance& allowed) {
        AdaptiveSubdivisionOptions subdivision = subdivision_options(layout, options);
        subdivision.max_triangles = allowed.most();
        return subdivider.subdivide(of_layer, search, plane, sampling, subdivision, outlines)
            .triangles;
    };
    const TriangleAllowance all(options.max_triangles);
    BlendTriangles thin;
    if (layout.drawing.draws_thin && !options.fade_beyond_capture)
        thin = thin_triangles(layout, views, eye, search, all.half().most());
    std::vector<TriangleAllowance> allowed = allowances_of(polygons, all.rest_after(thin.count()));
    std::vector<BlendTriangles> layers(polygons.size());
    PatchSampler::Options sampling = sampling_options(options);
    if (layers.size() > 1)
        sampling.before_shell = three_with_repeats(choose_depth_views(layout, eye, 3));
    for (std::size_t shell = 1; shell < layers.size(); ++shell) {
        layers[shell] = without_unseen(subdivided(polygons[shell], sampling, allowed[shell]));
        allowed[0].take_over(allowed[shell], layers[shell].count());
    }
    sampling.before_shell.reset();
    layers[0] = subdivided(polygons[0], sampling, allowed[0]);
    const std::vector<UnseenTriangle> partly_seen =
        draw_unseen(layout, eye, search, plane, sampling, layers[0]);
    // Guesses are not laid over anything, nor is what fades: what it fades over would show through.
    BlendTriangles parts;
    const bool has_room = allowed[0].has_room_after(layers[0].count());
    if (search.has_depth() && !options.fade_beyond_capture && has_room)
        parts = seen_parts(partly_seen, layers[0].vertices, {search, plane, sampling},
                           {.long_edge_px = 2 * subdivision_options(layout, options).min_edge_px,
                            .max_parts = allowed[0].rest_after(layers[0].count()).most()});
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
    const bool are_kept = is_made_for(eye, options);
    if (!are_kept) {
        forget_frame();
        layers_ =
            adaptive_layers(uploaded_.layout, uploaded_.searched_views, eye, options, subdivider_);
        made_for_ = Request{eye, options};
    }
    const bool has_surroundings = are_surroundings_drawn(options);
    if (has_surroundings) draw_surroundings(eye, options);
    DrawStatistics statistics{.are_triangles_kept = are_kept};
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
