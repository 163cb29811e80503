#include "render/reference/eye_depths.h"

#include <algorithm>

#include "meshing/surface/depth_map.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/transfer/past_sight.h"
#include "render/transfer/scene_plane.h"
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
    std::vector<PastSight> sights;
    for (const int index : result.view_indices) {
        const auto view = static_cast<std::size_t>(index);
        const auto mesh = depth_mesh_of(lumigraph.views[view], max_disparity_px(geometries[view]),
                                        depth_mesh_options(lumigraph));
        layers.push_back(
            rasterise(*mesh, lumigraph.views[view], eye, nearest_inverse_depth(lumigraph)));
        sights.emplace_back(lumigraph.views[view], eye);
    }
    std::vector<EyeDepth> depths(layers.size());
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            for (std::size_t layer = 0; layer < layers.size(); ++layer)
                depths[layer] = layers[layer](x, y);
            settle_lone_surface(depths, agreeing,
                                [&](std::size_t layer, double inverse_depth, double nearest_seen) {
                                    return sights[layer].past({x + 0.5, y + 0.5}, inverse_depth,
                                                              agreeing, nearest_seen);
                                });
            result.depths(x, y) = consensus_of(depths, agreeing);
        }
    }
    return result;
}

DepthMap depth_map_at(const Lumigraph& lumigraph, const Eye& eye, double tolerance_px) {
    const EyeDepths known = eye_depths(lumigraph, eye, tolerance_px);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    DepthMap map{FloatImage(eye.camera.width_px, eye.camera.height_px),
                 GrayImage(eye.camera.width_px, eye.camera.height_px)};
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const ConsensusDepth& depth = known.depths(x, y);
            const bool is_seen = depth.support > 0 && depth.kind == DepthKind::kSeen;
            const double guess = std::max(0.0, plane.dot(Eigen::Vector3d(x + 0.5, y + 0.5, 1)));
            map.inverse_depth(x, y) =
                static_cast<float>(depth.support > 0 ? std::max(0.0, depth.inverse_depth) : guess);
            map.confidence(x, y) = is_seen ? kKnown : kUnseen;
        }
    }
    return map;
}

Eigen::Vector3d point_in_world(const Eye& eye, int x, int y, double inverse_depth) {
    return inverse(eye.cam_from_world) *
           (unproject(eye.camera, {x + 0.5, y + 0.5}) / inverse_depth).eval();
}

}  // namespace lumi
