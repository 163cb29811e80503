#include "meshing/depth/finished_depth.h"

#include <algorithm>

#include "calib/work/parallel_for.h"
#include "meshing/depth/cross_view_check.h"
#include "meshing/depth/edge_aware_fill.h"
#include "meshing/depth/edge_snapping.h"
#include "meshing/depth/receding_fill.h"
#include "meshing/depth/sparse_depth.h"
#include "meshing/depth/surrounding_depth.h"

namespace lumi {
namespace {

double one_pixel_of(const DepthView& view) {
    return view.disparity_px_per_inverse_depth > 0 ? 1.0 / view.disparity_px_per_inverse_depth
                                                   : 0.0;
}

/// Continues what is known over the whole map, and tells how far.
FloatImage continued(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                     int view_index, DepthMap& map) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    return continue_known_depth(map, sparse_depth(view).inverse_depth, one_pixel_of(view),
                                surrounding_depth(scene, confirmed_maps, view_index));
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

std::optional<double> fill_recession(const DepthScene& scene, const std::vector<GrayImage>& masks,
                                     const std::vector<DepthMap>& confirmed_maps,
                                     const std::vector<DepthEstimate>& estimates, int threads) {
    constexpr std::size_t kMostViews = 32;
    std::vector<int> asked;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        if (!estimates[i].is_complete) asked.push_back(static_cast<int>(i));
    }
    const std::size_t count = std::min(kMostViews, asked.size());
    std::vector<std::vector<double>> differences(count);
    parallel_for(static_cast<int>(count), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const int view_index = asked[index * asked.size() / count];
        DepthMap map = confirmed_maps[static_cast<std::size_t>(view_index)];
        FloatImage distance_px = continued(scene, confirmed_maps, view_index, map);
        const GrayImage& mask = masks[static_cast<std::size_t>(view_index)];
        for (std::size_t k = 0; k < mask.pixels().size(); ++k) {
            if (mask.pixels()[k] == 0) distance_px.pixels()[k] = 0.0F;
        }
        differences[index] =
            recession_differences(scene, confirmed_maps, view_index, map, distance_px);
    });
    return chosen_recession(differences);
}

void fill_unknown_depth(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                        int view_index, double recession_px, DepthMap& map) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    const FloatImage distance_px = continued(scene, confirmed_maps, view_index, map);
    recede(recession_px, one_pixel_of(view), distance_px, map);
    smooth_filled_depth(map, view.photograph, one_pixel_of(view));
    snap_edges(map, view.photograph, one_pixel_of(view));
}

}  // namespace lumi
