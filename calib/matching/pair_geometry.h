#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "calib/colmap/colmap_database.h"

namespace lumi {

/// What a verified pair says about the motion between its photographs.
struct PairGeometry {
    VerifiedPair pair;
    /// Absent where the matches do not tell.
    std::optional<Eigen::Quaterniond> second_from_first;
    Eigen::Vector3d direction_in_first = Eigen::Vector3d::Zero();  ///< To the second camera.
    double median_angle_deg = 0.0;  ///< At which rays to the same point meet.
    bool epipoles_in_view = false;  ///< Each photograph shows the place of the other's camera.
};

/// The motion of a verified pair, for the lenses as they are believed to be: an essential matrix by
/// consensus (MAGSAC++; Barath et al., CVPR 2020). Deterministic.
[[nodiscard]] PairGeometry pair_geometry_of(const VerifiedPair& pair,
                                            const std::vector<ColmapPhotograph>& photographs,
                                            const std::vector<ColmapCamera>& cameras);

}  // namespace lumi
