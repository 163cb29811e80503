#pragma once

#include <array>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// Pixels of disparity for each unit of inverse depth and each pixel of the photograph between two
/// samples: steps from one sample of a depth map to the next become disparity gradients.
struct DisparityPerPitch {
    double along_row;
    double along_column;
};

/// `disparity_px` turns inverse depth into pixels of the photograph (view_geometry.h).
[[nodiscard]] DisparityPerPitch disparity_per_pitch(const DepthMap& depth, const Camera& camera,
                                                    double disparity_px);

/// The largest step of inverse depth between neighbouring samples that may be nothing: estimated
/// samples err by half of this either way.
[[nodiscard]] double gentle_step(double disparity_per_pitch);

/// Whether a surface tears between the second and the third of four samples in a row: the step is
/// neither gentle nor the continuation of the slope on one side. Where a map ends, its outermost
/// sample stands for the one beyond.
[[nodiscard]] bool tears(const std::array<float, 4>& inverse_depths, double disparity_per_pitch);

/// For each sample 1 where what lies between it and the ones to the right, below, and below right
/// is not one surface: it tears on a side of this square.
[[nodiscard]] GrayImage torn_squares(const FloatImage& inverse_depth,
                                     const DisparityPerPitch& disparity);

}  // namespace lumi
