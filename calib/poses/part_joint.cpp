#include "calib/poses/part_joint.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calib/poses/joint_fit.h"

namespace lumi {
namespace {

constexpr std::size_t kFewPoints = 60;  ///< Enough to show that a joint is strong.
constexpr std::size_t kMostPoints = 1000;
/// Where the joint is known to this share of what would matter, the points fill space or a large
/// part of the pictures, and there is no second minimum.
constexpr double kFirmShare = 0.05;
/// Logarithms of cost ratios times points, where each point speaks once (errors within a track go
/// together): to move a part takes a thousand to one, to trust where it stands twenty to one.
constexpr double kSureLogRatio = 13.8;
constexpr double kTrustedLogRatio = 6.0;

std::vector<std::size_t> shared_points(const Capture& capture,
                                       const std::vector<char>& is_in_part) {
    std::vector<std::size_t> shared;
    for (std::size_t index = 0; index < capture.points.size(); ++index) {
        const auto& track = capture.points[index].track;
        const auto inside = std::count_if(track.begin(), track.end(), [&](const auto& seen) {
            return is_in_part[static_cast<std::size_t>(seen.view_index)] != 0;
        });
        if (inside > 0 && inside < static_cast<std::ptrdiff_t>(track.size())) {
            shared.push_back(index);
        }
    }
    return shared;
}

std::vector<std::size_t> some_of(const std::vector<std::size_t>& all, std::size_t most) {
    if (all.size() <= most) return all;
    std::vector<std::size_t> some;
    for (std::size_t index = 0; index < most; ++index) {
        some.push_back(all[index * all.size() / most]);
    }
    return some;
}

/// The second minimum that explains the points best.
std::optional<OtherJoint> other_joint(const JointFit& fit, double cost_px2,
                                      const std::vector<std::size_t>& indices,
                                      const Progress& progress) {
    std::optional<OtherJoint> best;
    for (Similarity& other : fit.tilted()) {
        progress.throw_if_interrupted();
        std::vector<Eigen::Vector3d> points = fit.points();
        const double ratio = fit.minimise(other, points, nullptr) / std::max(cost_px2, 1e-12);
        if (best && ratio >= best->cost_ratio) continue;
        if (!std::isfinite(ratio)) continue;
        const PoseShift shift = fit.shift_by(other);
        if (!shift.matters()) continue;
        best = OtherJoint{fit.moved_by(other, indices, points), shift, ratio};
    }
    return best;
}

}  // namespace

bool PartJoint::is_elsewhere() const {
    return other && points * std::log(other->cost_ratio) < -kSureLogRatio;
}

bool PartJoint::is_weak() const {
    if (uncertainty.matters()) return true;
    return other && points * std::log(other->cost_ratio) < kTrustedLogRatio;
}

PartJoint examine_joint(const Capture& capture, const std::vector<char>& is_in_part,
                        double scale_px, const Progress& progress) {
    const std::vector<std::size_t> shared = shared_points(capture, is_in_part);
    PartJoint joint;
    if (shared.empty()) {
        constexpr double kInfinite = std::numeric_limits<double>::infinity();
        joint.uncertainty = {static_cast<int>(capture.views.size()), kInfinite, kInfinite};
        return joint;
    }
    for (const std::size_t most : {kFewPoints, kMostPoints}) {
        progress.throw_if_interrupted();
        const std::vector<std::size_t> some = some_of(shared, most);
        const JointFit fit(capture, is_in_part, some, scale_px);
        Similarity as_it_is;
        std::vector<Eigen::Vector3d> points = fit.points();
        joint.points = static_cast<int>(some.size());
        const double cost_px2 = fit.minimise(as_it_is, points, &joint.uncertainty);
        if (joint.uncertainty.position_share < kFirmShare * kMaxShiftShare &&
            joint.uncertainty.rotation_deg < kFirmShare * kMaxTurn_deg) {
            return joint;
        }
        if (some.size() < shared.size()) continue;
        joint.other = other_joint(fit, cost_px2, some, progress);
        return joint;
    }
    return joint;
}

}  // namespace lumi
