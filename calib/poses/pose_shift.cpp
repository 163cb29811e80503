#include "calib/poses/pose_shift.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "calib/poses/similarity_fit.h"

namespace lumi {

PoseShift pose_shift(const NamedPoses& poses, const NamedPoses& others) {
    std::vector<PosePair> pairs;
    NamedPoses placed_others;
    for (const auto& [name, pose] : poses) {
        const auto same = others.find(name);
        if (same == others.end()) continue;
        pairs.push_back({pose, same->second});
        placed_others.insert(*same);
    }
    PoseShift result;
    result.placed = static_cast<int>(pairs.size());
    if (pairs.empty()) return result;

    const Similarity3 fit = fit_with_rotation(pairs, mean_rotation(pairs));
    const double spread = spread_of_centres(placed_others);
    for (const PosePair& pair : pairs) {
        const Eigen::Vector3d centre =
            fit.scale * (fit.rotation * centre_in_world(pair.cam_from_a)) + fit.translation;
        const double error = (centre - centre_in_world(pair.cam_from_b)).norm();
        const double share = spread > 0 ? error / spread : std::numeric_limits<double>::infinity();
        result.position_share = std::max(result.position_share, share);
        const Eigen::Quaterniond turned = pair.cam_from_a.rotation * fit.rotation.conjugate();
        result.rotation_deg =
            std::max(result.rotation_deg,
                     turned.angularDistance(pair.cam_from_b.rotation) * 180.0 / std::numbers::pi);
    }
    return result;
}

double spread_of_centres(const NamedPoses& poses) {
    const double count = static_cast<double>(poses.size());
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    for (const auto& [name, pose] : poses) middle += centre_in_world(pose) / count;
    double square = 0;
    for (const auto& [name, pose] : poses) {
        square += (centre_in_world(pose) - middle).squaredNorm() / count;
    }
    return std::sqrt(square);
}

NamedPoses named_poses(const Capture& capture) {
    NamedPoses poses;
    for (const View& view : capture.views) poses[view.name] = view.cam_from_world;
    return poses;
}

}  // namespace lumi
