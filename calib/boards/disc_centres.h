#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/image.h"

namespace lumi {

/// A round blob: a printed disc, seen as an ellipse.
struct DiscImage {
    Eigen::Vector2d centre_px = Eigen::Vector2d::Zero();  ///< Centroid of its area.
    /// Second central moments of its area (px^2); a disc of radius r has r^2 / 4 in each direction.
    Eigen::Matrix2d moments_px2 = Eigen::Matrix2d::Identity();
    double area_px2 = 0.0;
    double contrast = 0.0;  ///< Grey levels, ground minus disc; negative for a bright disc.
};

/// Dark discs on bright ground and bright ones on dark ground. The centroid is that of the grey
/// values, weighted by how much of each pixel the disc covers.
[[nodiscard]] std::vector<DiscImage> detect_discs(const GrayImage& picture);

}  // namespace lumi
