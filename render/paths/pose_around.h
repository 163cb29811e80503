#pragma once

#include <Eigen/Geometry>

#include "calib/capture/rigid3.h"

namespace lumi {

/// The camera turned about a point in the world, with all its pose.
[[nodiscard]] Rigid3 turned_about(const Eigen::Vector3d& point, const Eigen::Quaterniond& turn,
                                  const Rigid3& cam_from_world);

/// The pose at a share of the way from one (0) to another (1) around a point in the world: the
/// direction from which the point is seen turns evenly, by the smaller angle, and so do distance
/// and aim change: the way leads past what stands at the point. From or to the point itself it is
/// straight.
[[nodiscard]] Rigid3 pose_around(const Eigen::Vector3d& point, const Rigid3& from, const Rigid3& to,
                                 double share);

}  // namespace lumi
