#pragma once

#include <ceres/ceres.h>

#include <cstddef>
#include <memory>
#include <vector>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/adjust/camera_blocks.h"
#include "calib/capture/capture.h"

namespace lumi {

/// The indices of a lens's parameters that stay as they are, ascending.
[[nodiscard]] std::vector<int> constant_lens_parameters(const Capture& capture,
                                                        std::size_t camera_index,
                                                        const BundleAdjustmentOptions& options);

[[nodiscard]] CameraBlocks camera_blocks(const Capture& capture);

/// Adds every observation, the manifolds of poses, what of the lenses is held, and the gauge.
/// The problem refers to `cameras` and the points of `capture`, which must not move.
void build_bundle_problem(ceres::Problem& problem, Capture& capture, CameraBlocks& cameras,
                          const BundleAdjustmentOptions& options, ceres::LossFunction* loss);

/// Points first (the elimination order that makes the Schur complement sparse), then poses, then
/// lenses.
[[nodiscard]] std::shared_ptr<ceres::ParameterBlockOrdering> elimination_order(
    const ceres::Problem& problem, Capture& capture, CameraBlocks& cameras);

}  // namespace lumi
