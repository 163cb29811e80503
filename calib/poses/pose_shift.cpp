#include "calib/poses/pose_shift.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace lumi {
namespace {

struct PosePair {
    Rigid3 pose;
    Rigid3 other;
};

/// From the world of the poses to that of the others.
Eigen::Quaterniond mean_rotation(const std::vector<PosePair>& pairs) {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const PosePair& pair : pairs) {
        sum += (pair.other.rotation.conjugate() * pair.pose.rotation).toRotationMatrix();
    }
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d proper = Eigen::Matrix3d::Identity();
    proper(2, 2) = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
    return Eigen::Quaterniond(svd.matrixU() * proper * svd.matrixV().transpose());
}

}  // namespace

PoseShift pose_shift(const NamedPoses& poses, const NamedPoses& others) {
    std::vector<PosePair> pairs;
    for (const auto& [name, pose] : poses) {
        const auto same = others.find(name);
        if (same != others.end()) pairs.push_back({pose, same->second});
    }
    PoseShift result;
    result.placed = static_cast<int>(pairs.size());
    if (pairs.empty()) return result;

    const double count = static_cast<double>(pairs.size());
    const Eigen::Quaterniond rotation = mean_rotation(pairs);
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    Eigen::Vector3d other_middle = Eigen::Vector3d::Zero();
    for (const PosePair& pair : pairs) {
        middle += rotation * centre_in_world(pair.pose) / count;
        other_middle += centre_in_world(pair.other) / count;
    }
    double product = 0;
    double square = 0;
    double spread = 0;
    for (const PosePair& pair : pairs) {
        const Eigen::Vector3d offset = rotation * centre_in_world(pair.pose) - middle;
        const Eigen::Vector3d other_offset = centre_in_world(pair.other) - other_middle;
        product += offset.dot(other_offset);
        square += offset.squaredNorm();
        spread += other_offset.squaredNorm() / count;
    }
    spread = std::sqrt(spread);
    const double scale = square > 0 ? product / square : 0.0;
    for (const PosePair& pair : pairs) {
        const Eigen::Vector3d centre =
            scale * (rotation * centre_in_world(pair.pose) - middle) + other_middle;
        const double error = (centre - centre_in_world(pair.other)).norm();
        const double share = spread > 0 ? error / spread : std::numeric_limits<double>::infinity();
        result.position_share = std::max(result.position_share, share);
        const Eigen::Quaterniond turned = pair.pose.rotation * rotation.conjugate();
        result.rotation_deg =
            std::max(result.rotation_deg,
                     turned.angularDistance(pair.other.rotation) * 180.0 / std::numbers::pi);
    }
    return result;
}

NamedPoses named_poses(const Capture& capture) {
    NamedPoses poses;
    for (const View& view : capture.views) poses[view.name] = view.cam_from_world;
    return poses;
}

}  // namespace lumi
