#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/surface/inverse_depth_range.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Inverse depths of the scene's far and near end, as the views see them; from the distance of the
/// scene's centre when the Lumigraph does not say.
[[nodiscard]] InverseDepthRange scene_inverse_depths(const Lumigraph& lumigraph);

/// The inverse depth of the nearest that an eye can look at: a hundredth of the distance of the
/// scene's near end.
[[nodiscard]] double nearest_inverse_depth(const Lumigraph& lumigraph);

/// What turns differences of inverse depth into pixels, the same for every eye.
struct ViewGeometry {
    Eigen::Vector3d centre_in_world = Eigen::Vector3d::Zero();
    double focal_px = 0.0;
    /// Median distance to the views it shares a face with, but for those at the same place; a tenth
    /// of the scene's depth without any.
    double baseline = 0.0;
};

[[nodiscard]] std::vector<ViewGeometry> view_geometries(const Lumigraph& lumigraph);

/// Pixels by which a view's picture is misplaced, as seen from the eye, for each unit that its
/// inverse depth is wrong: focal length times the distance between eye and view, but no more than
/// the view's own baseline, over which its depth was estimated (methods: 1.C, 1.D).
[[nodiscard]] double disparity_px_per_inverse_depth(const ViewGeometry& view,
                                                    const Eigen::Vector3d& eye_in_world);

/// The largest disparity_px_per_inverse_depth of a view, for any eye.
[[nodiscard]] double max_disparity_px(const ViewGeometry& view);

/// What a small difference of inverse depth in the views is in the eye, at the scene's centre: a
/// surface that is uncertain by so much for cameras is less so for an eye that is farther, by the
/// square of the median of their distances over the eye's. 16 at most: where the eye is nearer than
/// a quarter of the cameras' distance, what it looks at is not at the centre.
[[nodiscard]] double inverse_depth_in_eye(const std::vector<ViewGeometry>& views,
                                          const Eigen::Vector3d& scene_centre_in_world,
                                          const Eigen::Vector3d& eye_in_world);

/// Inverse depths in the eye that differ by no more than this are of one surface: each may be wrong
/// by the tolerance, in pixels of the median disparity of the views that they come from.
[[nodiscard]] double agreeing_inverse_depth(const Lumigraph& lumigraph,
                                            const std::vector<ViewGeometry>& views,
                                            const std::vector<int>& view_indices,
                                            const Eigen::Vector3d& eye_in_world,
                                            double tolerance_px);

}  // namespace lumi
