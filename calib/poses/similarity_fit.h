#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "calib/capture/rigid3.h"

namespace lumi {

/// `b = scale * (rotation * a) + translation`.
struct Similarity3 {
    double scale = 1.0;
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d translation = Eigen::Vector3d::Zero();
};

/// One camera in two worlds.
struct PosePair {
    Rigid3 cam_from_a;
    Rigid3 cam_from_b;
};

/// B from A: the mean of what the cameras' attitudes say (the chordal mean; Hartley et al.,
/// Rotation averaging, IJCV 2013). Expects at least one pair.
[[nodiscard]] Eigen::Quaterniond mean_rotation(const std::vector<PosePair>& pairs);

/// With this rotation; scale and translation are least squares over the centres. The scale is 1
/// where the cameras of either world stand at one place, since nothing tells it. Expects at least
/// one pair.
[[nodiscard]] Similarity3 fit_with_rotation(const std::vector<PosePair>& pairs,
                                            const Eigen::Quaterniond& rotation);

/// Fits A's centres onto B's in the least squares sense (Umeyama 1991). What the centres leave open
/// the attitudes decide: the turn about the line that centres stand on, up to a twentieth of its
/// length, and the whole rotation where they stand at one place. Expects at least one pair.
[[nodiscard]] Similarity3 fit_centres(const std::vector<PosePair>& pairs);

}  // namespace lumi
