#pragma once

#include <Eigen/Core>
#include <optional>

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The plane that is sharp where photographs are blended without depth: the movable focal surface
/// of Isaksen, McMillan and Gortler (SIGGRAPH 2000). It stands across a camera's optical axis.
struct FocalPlane {
    double depth = 0.0;  ///< Distance along that axis, in world units; 0: there is no such plane.
    /// The pose of the camera across whose axis it stands fixed in the scene; empty: it stands
    /// across the eye's axis, and moves with it.
    std::optional<Rigid3> cam_from_world{};

    bool operator==(const FocalPlane&) const = default;
};

/// The plane as a linear function of the pixel: the eye's inverse depth at (x, y) is
/// max(0, line . (x, y, 1)), which is 0, infinitely far, where the ray leads away from the plane,
/// and for an eye that stands in it. The plane's depth must be positive.
[[nodiscard]] Eigen::Vector3d focal_plane_inverse_depth(const FocalPlane& plane, const Eye& eye);

}  // namespace lumi
