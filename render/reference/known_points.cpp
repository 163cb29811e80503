#include "render/reference/known_points.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "render/transfer/focal_plane.h"
#include "render/transfer/scene_plane.h"

namespace lumi {

KnownPoints::KnownPoints(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                         const Eye& eye, const RenderOptions& options)
    : eye_(eye),
      plane_inverse_depth_(options.focal_plane.depth > 0 && options.mode != RenderMode::kPerPixel
                               ? focal_plane_inverse_depth(options.focal_plane, eye)
                               : scene_plane_inverse_depth(lumigraph, eye)) {
    if (options.mode == RenderMode::kPerPixel && lumigraph.has_depth())
        depth_.emplace(lumigraph, geometries, eye, options);
}

Eigen::Vector3d KnownPoints::direction_in_world(const Eigen::Vector2d& pixel) const {
    return eye_.cam_from_world.rotation.conjugate() * unproject(eye_.camera, pixel);
}

std::vector<KnownPoint> KnownPoints::at(const Eigen::Vector2d& pixel) const {
    std::vector<KnownPoint> points;
    for (const auto& [depth, known_by, of_views] :
         depth_ ? depth_->samples_at(pixel) : std::vector<AgreedPixelDepth>(1)) {
        const double inverse_depth =
            depth.support > 0 ? depth.inverse_depth
                              : std::max(0.0, plane_inverse_depth_.dot(pixel.homogeneous()));
        points.push_back({{direction_in_world(pixel), inverse_depth, known_by}, depth, of_views});
    }
    return points;
}

}  // namespace lumi
