#include "meshing/depth/finished_depth.h"

#include <algorithm>

#include "meshing/depth/cross_view_check.h"
#include "meshing/depth/edge_aware_fill.h"
#include "meshing/depth/edge_snapping.h"
#include "meshing/depth/sparse_depth.h"
#include "meshing/depth/surrounding_depth.h"

namespace lumi {
namespace {

double one_pixel_of(const DepthView& view) {
    return view.disparity_px_per_inverse_depth > 0 ? 1.0 / view.disparity_px_per_inverse_depth
                                                   : 0.0;
}

}  // namespace

DepthMap confirmed_depth(const DepthScene& scene, const std::vector<DepthEstimate>& estimates,
                         int view_index) {
    constexpr double kIslandShare = 5e-4;  // Of the picture.
    const auto index = static_cast<std::size_t>(view_index);
    if (!estimates[index].needs_confirmation) return estimates[index].map;
    DepthMap map = cross_view_check(scene, estimates, view_index);
    const auto pixels = static_cast<double>(map.confidence.pixels().size());
    remove_speckles(map, 2 * one_pixel_of(scene.views[index]),
                    std::max(16, static_cast<int>(kIslandShare * pixels)));
    return map;
}

void fill_unknown_depth(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                        int view_index, DepthMap& map) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    edge_aware_fill(map, view.photograph, sparse_depth(view).inverse_depth, one_pixel_of(view),
                    surrounding_depth(scene, confirmed_maps, view_index));
    snap_edges(map, view.photograph, one_pixel_of(view));
}

}  // namespace lumi
