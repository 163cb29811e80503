#pragma once

#include <Eigen/Core>
#include <span>

#include "calib/capture/camera.h"

namespace lumi {

/// How many places all over the picture the pixels cover: cells of 2 x 2, 4 x 4, ... 64 x 64 grids
/// that are hit, each worth the cells in its grid (Schönberger and Frahm, CVPR 2016, section 4.2).
[[nodiscard]] double visibility_score(const Camera& camera,
                                      std::span<const Eigen::Vector2d> pixels);

}  // namespace lumi
