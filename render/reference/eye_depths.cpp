#include "render/reference/eye_depths.h"

#include "render/depth_mesh/view_depth_mesh.h"
#include "render/transfer/view_geometry.h"
#include "render/view_choice/depth_view_choice.h"

namespace lumi {

EyeDepths eye_depths(const Lumigraph& lumigraph, const Eye& eye, double tolerance_px) {
    const std::vector<ViewGeometry> geometries = view_geometries(lumigraph);
    EyeDepths result{Image<ConsensusDepth>(eye.camera.width_px, eye.camera.height_px),
                     choose_depth_views(lumigraph, eye, lumigraph.drawing.depth_views)};
    const double agreeing =
        agreeing_inverse_depth(lumigraph, geometries, result.view_indices,
                               centre_in_world(eye.cam_from_world), tolerance_px);
    std::vector<Image<EyeDepth>> layers;
    for (const int index : result.view_indices) {
        const auto view = static_cast<std::size_t>(index);
        const auto mesh = depth_mesh_of(lumigraph.views[view], max_disparity_px(geometries[view]),
                                        depth_mesh_options(lumigraph));
        layers.push_back(rasterise(*mesh, lumigraph.views[view], eye));
    }
    std::vector<EyeDepth> depths(layers.size());
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            for (std::size_t layer = 0; layer < layers.size(); ++layer)
                depths[layer] = layers[layer](x, y);
            result.depths(x, y) = consensus_of(depths, agreeing);
        }
    }
    return result;
}

Eigen::Vector3d point_in_world(const Eye& eye, int x, int y, double inverse_depth) {
    return inverse(eye.cam_from_world) *
           (unproject(eye.camera, {x + 0.5, y + 0.5}) / inverse_depth).eval();
}

}  // namespace lumi
