#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <string>
#include <vector>

namespace lumi {

/// Weights of the ray from the eye to the target, one a camera, in the frame of that eye.
using WayOfWeighing =
    std::function<std::vector<double>(const Eigen::Vector3d& eye, const Eigen::Vector3d& target)>;

/// Where the bins of inconsistency end; the first holds what is 0 up to rounding.
inline constexpr std::array<double, 7> kInconsistencyBinEnds{1e-9, 1e-3, 0.01, 0.03, 0.1, 0.3, 1.0};

/// How consistent and how continuous one way of weighing rays is.
struct WeightsFigures {
    std::string name;
    /// Half the sum of differences between the weights of one ray in two frames, whose eyes stand
    /// at different places on it: 0 is the same picture in both, 1 one from other photographs, and
    /// a half a picture in one of them alone.
    double mean_inconsistency = 0.0;
    /// Of the rays, those that some camera has weight for in one of the two frames at least. All
    /// else is of these, and of steps of paths that are so at one end at least: nothing, twice, is
    /// no agreement.
    double covered_share = 0.0;
    double largest_inconsistency = 0.0;
    /// Shares of the rays, by their inconsistency: up to the end of each bin and above the one
    /// before. They sum to 1.
    std::array<double, kInconsistencyBinEnds.size()> inconsistency_shares{};
    double largest_jump = 0.0;    ///< Sum of differences across one place on a path of the eye.
    double jumps_per_path = 0.0;  ///< Places where the weights change by more than 1e-6 at once.
    /// Sum of differences between the weights of one step of a path and the next, over the share
    /// of the path that the step is: what 99 of 100 steps do not exceed, and the most.
    double continuity_p99 = 0.0;
    double continuity_max = 0.0;
};

/// Collects rays and paths of one way of weighing.
class WeightsMeasurement {
 public:
    explicit WeightsMeasurement(std::string name) { figures_.name = std::move(name); }

    /// A ray, seen by two eyes on it.
    void add_ray(const WayOfWeighing& weigh, const Eigen::Vector3d& eye,
                 const Eigen::Vector3d& other_eye, const Eigen::Vector3d& target);
    /// The eye goes from direction `from` to `to` on an arc about the target, and from 1.2 to 2.2
    /// units off.
    void add_path(const WayOfWeighing& weigh, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& to, const Eigen::Vector3d& target);

    [[nodiscard]] WeightsFigures figures() const;

 private:
    WeightsFigures figures_;
    double sum_ = 0.0;
    long rays_ = 0;  ///< Covered ones.
    long uncovered_rays_ = 0;
    std::array<long, kInconsistencyBinEnds.size()> rays_in_bins_{};
    long jumps_ = 0;
    int paths_ = 0;
    std::vector<double> changes_;  ///< Of each step, over its share of the path.
};

}  // namespace lumi
