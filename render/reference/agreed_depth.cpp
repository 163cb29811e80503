#include "render/reference/agreed_depth.h"

#include <algorithm>

#include "render/depth_mesh/view_depth_mesh.h"
#include "render/reference/depth_raster.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {

AgreedDepth::AgreedDepth(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                         const Eye& eye, const RenderOptions& options)
    : depth_eye_(depth_eye(lumigraph, eye, options)) {
    const std::vector<DepthViewSet> sets = depth_view_sets(lumigraph, eye, lumigraph.depth_views);
    strip_ends_ = strip_ends(sets, depth_eye_.eye.camera.width_px);
    layer_views_ = depth_layer_views(sets, lumigraph.depth_views);
    agreeing_inverse_depth_ =
        agreeing_inverse_depth(lumigraph, geometries, sets, centre_in_world(eye.cam_from_world),
                               options.occlusion_tolerance_px);
    for (const DepthViewSet& set : sets) {
        for (const int index : set.view_indices) {
            if (eye_depth_of_view_.contains(index)) continue;
            const auto view_index = static_cast<std::size_t>(index);
            const LumigraphView& view = lumigraph.views[view_index];
            const auto mesh = depth_mesh_of(view, max_disparity_px(geometries[view_index]));
            eye_depth_of_view_[index] = rasterise(*mesh, view, depth_eye_.eye);
        }
    }
}

AgreedPixelDepth AgreedDepth::at(const Eigen::Vector2d& pixel) const {
    const int column = texel(pixel.x());
    const int row = texel(pixel.y());
    const std::vector<int>& views = views_at(column);
    AgreedPixelDepth agreed;
    std::vector<EyeDepth> depths;
    for (const int index : views) {
        depths.push_back(index == kNoView ? EyeDepth{} : eye_depth_of_view_.at(index)(column, row));
        if (index != kNoView) agreed.of_views[index] = depths.back();
    }
    agreed.depth = consensus_of(depths, agreeing_inverse_depth_);
    if (agreed.depth.support > 0)
        agreed.known_by = views[static_cast<std::size_t>(agreed.depth.best_layer)];
    return agreed;
}

const std::vector<int>& AgreedDepth::views_at(int column) const {
    const auto end = std::upper_bound(strip_ends_.begin(), strip_ends_.end(), column);
    return layer_views_[static_cast<std::size_t>(end - strip_ends_.begin())];
}

}  // namespace lumi
