#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "calib/capture/rigid3.h"

namespace lumi {

/// Cosine of 45 degrees: cameras whose axes are farther from the eye's take no part. The paper's
/// cameras all look one way. Where cameras stand all around a scene and the eye looks at it as they
/// do, the more a camera looks aside, the nearer to the middle of the picture its centre is
/// projected: the triangles there are of the cameras least fit for it, hence the limit.
inline constexpr double kHeiglLeastCosine = 0.70710678;

/// The weights of Heigl et al. ("Plenoptic modeling and rendering from image sequences taken by a
/// hand-held camera", DAGM 1999), to compare with: all camera centres are projected into the novel
/// view and triangulated there (Delaunay), anew for each frame; a ray is blended from the triangle
/// that its pixel lies in. The triangles depend on the eye, so the same ray may be blended
/// differently in another frame.
class HeiglFrame {
 public:
    /// Cameras that look elsewhere take no part (kHeiglLeastCosine); axes have length 1. Of a
    /// camera before the eye or behind it the line through both counts; the eye at a camera has
    /// that camera's weights, and in a camera's plane it is taken to be a little beside it: as they
    /// are drawn (render/rivals/heigl.h).
    HeiglFrame(const std::vector<Eigen::Vector3d>& centres_in_world,
               const std::vector<Eigen::Vector3d>& axes_in_world, const Rigid3& eye_from_world);
    ~HeiglFrame();
    HeiglFrame(HeiglFrame&& other) noexcept;
    HeiglFrame& operator=(HeiglFrame&& other) noexcept;

    /// One weight a camera; they sum to 1, or are all 0 where no triangle lies.
    [[nodiscard]] std::vector<double> weights_towards(const Eigen::Vector3d& target_in_world) const;

 private:
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace lumi
