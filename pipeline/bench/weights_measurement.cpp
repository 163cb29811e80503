#include "pipeline/bench/weights_measurement.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "calib/work/median.h"
#include "pipeline/bench/largest_jump.h"
#include "pipeline/synth/hand_held_path.h"

namespace lumi {
namespace {

constexpr int kMeshPathSteps = 300;
/// Steps that change the weights by less hold no jump worth looking for.
constexpr double kSuspiciousChange = 1e-3;
constexpr double kJump = 1e-6;
constexpr JumpSearch kMeshJumpSearch{.halvings = 36};

double difference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(a[i] - b[i]);
    return sum;
}

/// Whether some camera has weight.
bool is_covered(const std::vector<double>& weights) {
    return std::any_of(weights.begin(), weights.end(), [](double weight) { return weight != 0; });
}

}  // namespace

void WeightsMeasurement::add_ray(const WayOfWeighing& weigh, const Eigen::Vector3d& eye,
                                 const Eigen::Vector3d& other_eye, const Eigen::Vector3d& target) {
    const std::vector<double> weights = weigh(eye, target);
    const std::vector<double> other_weights = weigh(other_eye, target);
    if (!is_covered(weights) && !is_covered(other_weights)) {
        ++uncovered_rays_;
        return;
    }
    const double inconsistency = 0.5 * difference(weights, other_weights);
    sum_ += inconsistency;
    ++rays_;
    figures_.largest_inconsistency = std::max(figures_.largest_inconsistency, inconsistency);
    // What rounding lifts above 1 is in the last bin.
    const auto bin = std::lower_bound(kInconsistencyBinEnds.begin(),
                                      std::prev(kInconsistencyBinEnds.end()), inconsistency);
    ++rays_in_bins_[static_cast<std::size_t>(bin - kInconsistencyBinEnds.begin())];
}

void WeightsMeasurement::add_path(const WayOfWeighing& weigh, const Eigen::Vector3d& from,
                                  const Eigen::Vector3d& to, const Eigen::Vector3d& target) {
    const Eigen::Quaterniond turn = turn_between(from, to);
    const auto weights_at = [&](double t) {
        const Eigen::Quaterniond part = Eigen::Quaterniond::Identity().slerp(t, turn);
        return weigh(target + (1.2 + t) * (part * from.normalized()), target);
    };
    std::vector<double> before = weights_at(0);
    for (int step = 1; step <= kMeshPathSteps; ++step) {
        const double t = static_cast<double>(step) / kMeshPathSteps;
        std::vector<double> after = weights_at(t);
        const double change = difference(before, after);
        if (is_covered(before) || is_covered(after)) changes_.push_back(change * kMeshPathSteps);
        if (change > kSuspiciousChange) {
            const double jump = largest_jump_between(weights_at, difference,
                                                     t - 1.0 / kMeshPathSteps, t, kMeshJumpSearch);
            figures_.largest_jump = std::max(figures_.largest_jump, jump);
            if (jump > kJump) ++jumps_;
        }
        before = std::move(after);
    }
    ++paths_;
}

WeightsFigures WeightsMeasurement::figures() const {
    WeightsFigures figures = figures_;
    if (rays_ > 0) {
        figures.covered_share =
            static_cast<double>(rays_) / static_cast<double>(rays_ + uncovered_rays_);
        figures.mean_inconsistency = sum_ / static_cast<double>(rays_);
        for (std::size_t i = 0; i < rays_in_bins_.size(); ++i)
            figures.inconsistency_shares[i] =
                static_cast<double>(rays_in_bins_[i]) / static_cast<double>(rays_);
    }
    if (paths_ > 0) figures.jumps_per_path = static_cast<double>(jumps_) / paths_;
    if (!changes_.empty()) {
        figures.continuity_p99 = quantile_of(changes_, 0.99);
        figures.continuity_max = quantile_of(changes_, 1.0);
    }
    return figures;
}

}  // namespace lumi
