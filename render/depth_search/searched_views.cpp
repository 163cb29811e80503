#include "render/depth_search/searched_views.h"

#include "calib/work/parallel_for.h"
#include "render/depth_mesh/surface_tears.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {
namespace {

GrayImage torn_squares_of(const LumigraphView& view, double disparity_px) {
    return torn_squares(view.depth.inverse_depth,
                        disparity_per_pitch(view.depth, view.camera, disparity_px));
}

}  // namespace

SearchedViews searched_views(const Lumigraph& lumigraph) {
    SearchedViews views{view_geometries(lumigraph), std::vector<TiledDepth>(lumigraph.views.size()),
                        std::vector<std::vector<OutlinePoint>>(lumigraph.views.size()),
                        std::vector<ThinSurfaces>(lumigraph.views.size())};
    parallel_for(static_cast<int>(lumigraph.views.size()), 0, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const LumigraphView& view = lumigraph.views[index];
        const double disparity_px = max_disparity_px(views.geometries[index]);
        if (!view.has_depth()) return;
        const GrayImage torn = torn_squares_of(view, disparity_px);
        views.depths[index] = {view.depth, torn};
        views.outlines[index] = view_outlines(view, torn);
    });
    if (lumigraph.drawing.draws_thin) views.thin = thin_surfaces_of(lumigraph, views.geometries);
    return views;
}

std::vector<ThinSurfaces> thin_surfaces_of(const Lumigraph& lumigraph,
                                           const std::vector<ViewGeometry>& geometries) {
    std::vector<ThinSurfaces> thin(lumigraph.views.size());
    parallel_for(static_cast<int>(thin.size()), 0, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        thin[index] = thin_surfaces(lumigraph.views[index], max_disparity_px(geometries[index]),
                                    depth_mesh_options(lumigraph));
    });
    return thin;
}

}  // namespace lumi
