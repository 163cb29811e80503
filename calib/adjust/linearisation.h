#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/capture/capture.h"

namespace lumi {

/// Where the unknowns of poses and lenses stand in the normal equations of a bundle adjustment from
/// which the points are eliminated: six for each pose, then what is free of each lens.
struct UnknownsLayout {
    std::vector<Eigen::Index> pose_of_view;                ///< -1: the view has no observation.
    std::vector<std::vector<Eigen::Index>> lens_unknowns;  ///< By camera, parameter; -1: held.
    Eigen::Index unknowns = 0;
};

[[nodiscard]] UnknownsLayout unknowns_layout(const Capture& capture,
                                             const BundleAdjustmentOptions& options);

/// One observation, linear: by its pose (a turn of the camera, then a shift), by what is free of
/// its lens, by the point.
struct LinearisedSight {
    Eigen::Vector2d residual_px;
    Eigen::Matrix<double, 2, Eigen::Dynamic, Eigen::RowMajor, 2, 18> by_camera;
    Eigen::Matrix<double, 2, 3> by_point;
    std::array<Eigen::Index, 18> unknowns;  ///< Of the columns of `by_camera`.
};

/// Derivatives of every lens model come from the cost that the adjustment itself minimises.
class Linearisation {
 public:
    Linearisation(const Capture& capture, const UnknownsLayout& layout)
        : capture_(capture), layout_(layout) {}

    /// False when the point is not in front of the camera.
    [[nodiscard]] bool at(const ScenePoint& point, const Observation& seen,
                          LinearisedSight& result) const;

 private:
    const Capture& capture_;
    const UnknownsLayout& layout_;
};

}  // namespace lumi
