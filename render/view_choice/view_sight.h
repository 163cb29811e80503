#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/depth_search/points_in_view.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What each more view of the same is worth, of what the one before it was: the less, the more a
/// narrow strip counts that no other shows; the more, the nearer to the eye are those that must
/// agree.
inline constexpr double kWorthOfNext = 0.5;
/// What a view is worth for what may stand before the scene plane.
inline constexpr double kWorthBeforePlane = 0.1;

/// Points that the eye may see, two a pixel: on the scene plane (scene_plane.h) and, for less, at
/// the scene's near end. A view whose photograph holds a ray's far part alone cannot tell what
/// stands before it.
struct SightSamples {
    RayPoints points;
    /// What seeing each point from the eye's direction is worth to a view: first the points on the
    /// plane, in the order of the pixels, then those before it.
    Eigen::RowVectorXd worth;
};

[[nodiscard]] SightSamples sight_samples(const Lumigraph& lumigraph, const Eye& eye,
                                         const std::vector<Eigen::Vector2d>& pixels);

/// How a view sees the samples.
struct ViewSight {
    /// 1 within the photograph, 0 outside; from one to the other over a fraction of the way between
    /// two of kSightSteps in a row over the photograph.
    Eigen::RowVectorXd inside;
    Eigen::RowVectorXd closeness;  ///< The same, the less the larger the angle to the eye.
};

/// Samples in a row over a picture: what a view sees of it is known no finer.
inline constexpr int kSightSteps = 16;

[[nodiscard]] ViewSight sight_of(const LumigraphView& view, const Eigen::Vector3d& eye_in_world,
                                 const RayPoints& points);

}  // namespace lumi
