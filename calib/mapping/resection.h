#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "calib/capture/rigid3.h"

namespace lumi {

struct ResectionOptions {
    double max_error_px = 8.0;  ///< Of a point that agrees. > 0.
    int max_trials = 2000;      ///< > 0.
};

struct Resection {
    Rigid3 cam_from_world;
    std::vector<char> is_inlier;  ///< One per point.
    int inliers = 0;
};

/// Where a camera stood that saw scene points in the directions `rays` (at depth 1, free of lens
/// distortion): three points at a time propose a pose (P3P: Gao et al., PAMI 2003), the one that
/// most points agree with is refined by least squares over them. The same in every run. Empty when
/// fewer than four points agree on anything.
[[nodiscard]] std::optional<Resection> resect(std::span<const Eigen::Vector3d> points_in_world,
                                              std::span<const Eigen::Vector2d> rays,
                                              double focal_length_px,
                                              const ResectionOptions& options);

}  // namespace lumi
