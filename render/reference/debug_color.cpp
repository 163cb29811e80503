#include "render/reference/debug_color.h"

#include <algorithm>
#include <cmath>

#include "render/subdivision/blend_triangles.h"

namespace lumi {
namespace {

/// A colour for an index; neighbours differ (golden ratio).
Eigen::Vector3d index_color(int index) {
    const double turn = 0.618034 * index - std::floor(0.618034 * index);
    constexpr double kFullTurn = 6.2831853;
    return 255 * (Eigen::Vector3d::Constant(0.5) +
                  0.5 * Eigen::Vector3d(std::cos(kFullTurn * turn),
                                        std::cos(kFullTurn * (turn + 1.0 / 3)),
                                        std::cos(kFullTurn * (turn + 2.0 / 3))));
}

}  // namespace

double confidence_of(const ConsensusDepth& depth) {
    if (depth.support == 0) return 0;
    if (depth.is_behind_tears) return static_cast<double>(kStretchedConfidence);
    if (depth.kind == DepthKind::kSeen) return static_cast<double>(kSeenByOne) * depth.support;
    return static_cast<double>(depth.kind == DepthKind::kFilled ? kFilledConfidence
                                                                : kStretchedConfidence);
}

Eigen::Vector3d debug_color(DebugPicture picture, const ShownRay& ray,
                            const InverseDepthRange& scene) {
    const Eigen::Vector3d white = Eigen::Vector3d::Constant(255);
    if (picture == DebugPicture::kFaces) return index_color(ray.face_index);
    if (picture == DebugPicture::kOcclusion) return ray.occluded * white;
    if (picture == DebugPicture::kConfidence) return ray.confidence * white;
    if (picture == DebugPicture::kDepth) {
        const double share = (ray.inverse_depth - scene.far) / (scene.near - scene.far);
        return std::clamp(share, 0.0, 1.0) * white;
    }
    if (ray.is_unseen) return white;
    Eigen::Vector3d color = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < 3; ++i) color += ray.weights[i] * index_color(ray.view_indices[i]);
    return color;
}

}  // namespace lumi
