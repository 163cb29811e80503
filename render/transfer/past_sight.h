#pragma once

#include <Eigen/Core>
#include <limits>

#include "calib/capture/inverse_depth_warp.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Whether several views agree on a pixel of a depth map (DepthMap::confidence). Not on what is
/// infinitely far: a mask may have put it there, which nobody has measured.
[[nodiscard]] bool is_agreed_on(const DepthMap& depth, int x, int y);

/// Whether a view looks past a point.
enum class Past {
    kNot,      ///< It sees the point or something before it, or the point is not in its photograph.
    kPerhaps,  ///< By what it alone has seen, or what was filled.
    kSurely,   ///< Several views agree on what it sees behind the point.
};

/// No limit on how near to the eye what a view sees behind a point may be.
inline constexpr double kAnywhere = std::numeric_limits<double>::infinity();

/// Where several agree that there is nothing, all but infinitely far, only a view that sees nothing
/// either looks past what stands before that: one that sees another surface behind it does not say
/// that the ray is free. `agreeing`: what inverse depths of one surface may differ by.
[[nodiscard]] inline double nearest_seen_past_for(double agreed_inverse_depth, double agreeing) {
    return agreed_inverse_depth <= agreeing ? agreeing : kAnywhere;
}

/// A view, as it is asked whether it looks past points on the rays of one eye.
class PastSight {
 public:
    /// The view must have depth, and stay.
    PastSight(const LumigraphView& view, const Eye& eye);

    /// Whether the view's depth map has, where the point at `inverse_depth` on the eye's ray
    /// through `pixel` lies in it, something behind that point, by more than `least_difference` as
    /// inverse depth of the eye, and at no more than `nearest_seen` of it.
    [[nodiscard]] Past past(const Eigen::Vector2d& pixel, double inverse_depth,
                            double least_difference, double nearest_seen = kAnywhere) const;

    /// The warp from the eye's pixels to samples of the depth map.
    [[nodiscard]] const InverseDepthWarp& samples_from_eye() const { return samples_from_eye_; }

 private:
    InverseDepthWarp samples_from_eye_;
    const DepthMap* depth_;
};

}  // namespace lumi
