#pragma once

#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/matching/camera_groups.h"
#include "calib/matching/rotation_check.h"

namespace lumi {

/// Throws Error when the verified pairs show that no depth can come of the photographs:
/// E-POSES-ROTATION.
void refuse_turning_camera(const MotionEvidence& motion);

/// Over points and pairs of views of their tracks: the angle between the two views' rays. Median
/// over points of the largest angle of each.
[[nodiscard]] double median_triangulation_angle_deg(const Capture& capture);

/// Smallest over largest standard deviation of the points' cloud, outliers set aside: 0 for points
/// in one plane.
[[nodiscard]] double relative_thickness(const Capture& capture);

/// Looks at a finished model for success that only looks like one: two views through an unknown
/// lens (E-POSES-FEW), rays nearly parallel (E-POSES-ROTATION), focal lengths that no lens has
/// (E-POSES-FOCAL), points in one plane while the focal length was unknown (E-POSES-PLANAR; Wu,
/// Critical configurations for radial distortion self-calibration, CVPR 2014). Returns what is
/// suspicious but may be right.
[[nodiscard]] std::vector<std::string> check_model(const Capture& capture, bool lens_is_known);

}  // namespace lumi
