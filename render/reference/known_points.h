#pragma once

#include <Eigen/Core>
#include <map>
#include <optional>
#include <vector>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"
#include "render/reference/agreed_depth.h"
#include "render/reference/point_in_views.h"
#include "render/transfer/view_geometry.h"

namespace lumi {

/// A point on an eye's ray with how it is known. Without any support: the scene plane, for the mode
/// that draws it or as a guess.
struct KnownPoint {
    RayPoint point;
    ConsensusDepth depth;
    std::map<int, EyeDepth> of_views;  ///< What those say that were asked.
};

/// Where the rays of an eye meet the scene, or what stands for it.
class KnownPoints {
 public:
    /// The Lumigraph must outlive it; `geometries` are those of its views (view_geometry.h).
    KnownPoints(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                const Eye& eye, const RenderOptions& options);

    /// What the views agree on; none where a plane is drawn.
    [[nodiscard]] const std::optional<AgreedDepth>& depth() const { return depth_; }
    /// The ray through a pixel, scaled to depth 1 along the eye's optical axis.
    [[nodiscard]] Eigen::Vector3d direction_in_world(const Eigen::Vector2d& pixel) const;
    /// The points of a pixel: one, or one for each surface of a silhouette that is drawn smoothly.
    [[nodiscard]] std::vector<KnownPoint> at(const Eigen::Vector2d& pixel) const;

 private:
    Eye eye_;
    Eigen::Vector3d plane_inverse_depth_;  ///< Affine in the pixel (scene_plane.h).
    std::optional<AgreedDepth> depth_;
};

}  // namespace lumi
