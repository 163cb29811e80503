#include "render/rivals/resampled_lumigraph.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "render/reference/eye_depths.h"
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

constexpr double kTolerance_px = 1.5;

bool has_depth(const Lumigraph& lumigraph) {
    return std::any_of(lumigraph.views.begin(), lumigraph.views.end(),
                       [](const auto& view) { return !view.depth.inverse_depth.empty(); });
}

/// The scene plane without confidence where nothing is known.
DepthMap depth_of(const Lumigraph& source, const Eye& eye) {
    const EyeDepths known = eye_depths(source, eye, kTolerance_px);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(source, eye);
    DepthMap map{FloatImage(eye.camera.width_px, eye.camera.height_px),
                 GrayImage(eye.camera.width_px, eye.camera.height_px)};
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const ConsensusDepth& depth = known.depths(x, y);
            const bool is_seen = depth.support > 0 && depth.kind == DepthKind::kSeen;
            const double guess = std::max(0.0, plane.dot(Eigen::Vector3d(x + 0.5, y + 0.5, 1)));
            map.inverse_depth(x, y) =
                static_cast<float>(depth.support > 0 ? depth.inverse_depth : guess);
            map.confidence(x, y) = is_seen ? 255 : 0;
        }
    }
    return map;
}

}  // namespace

Eigen::Matrix3d rotation_with_axis(const Eigen::Vector3d& z, const Eigen::Vector3d& down) {
    const Eigen::Vector3d x = down.cross(z).normalized();
    Eigen::Matrix3d rotation;
    rotation.row(0) = x;
    rotation.row(1) = z.cross(x);
    rotation.row(2) = z;
    return rotation;
}

Lumigraph resampled(const Lumigraph& source, LightFieldLayout layout, const DrawEye& draw) {
    Lumigraph result = without_its_views(source);
    result.mesh = std::move(layout.mesh);
    const bool with_depth = has_depth(source);
    for (std::size_t i = 0; i < layout.eyes.size(); ++i) {
        const Eye& eye = layout.eyes[i];
        result.views.push_back({"resampled " + std::to_string(i + 1), eye.camera,
                                eye.cam_from_world, 1, draw(eye).color,
                                with_depth ? depth_of(source, eye) : DepthMap{}});
    }
    return result;
}

}  // namespace lumi
