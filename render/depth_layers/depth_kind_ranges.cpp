#include "render/depth_layers/depth_kind_ranges.h"

#include <algorithm>

namespace lumi {

double agreeing_in_layers(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                          const std::vector<DepthViewSet>& sets,
                          const Eigen::Vector3d& eye_in_world) {
    return std::min(
        agreeing_inverse_depth(lumigraph, geometries, sets, eye_in_world, kAgreeingDisparity_px),
        kMostAgreeingDepth / kDepthKindWidth * nearest_inverse_depth(lumigraph));
}

}  // namespace lumi
