#pragma once

#include <vector>

#include "calib/capture/capture.h"
#include "calib/poses/pose_shift.h"

namespace ceres {
class LossFunction;
class Problem;
}  // namespace ceres

namespace lumi {

/// Where the world of the others goes in that of the part: turned and scaled about the middle of
/// the points that both see, then moved.
struct Similarity {
    Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();
    double log_scale = 0.0;
};

/// How a rigid part of a capture stands to the rest, by robust least squares over points that both
/// see: reprojection in pixels as a function of the similarity between them and of the points.
/// Keeps references: the capture and the choice of the part must outlive it.
class JointFit {
 public:
    /// `points`: indices of points that views of the part and others see; `scale_px`: of Cauchy's
    /// loss (cauchy_scale_px).
    JointFit(const Capture& capture, const std::vector<char>& is_in_part,
             const std::vector<std::size_t>& points, double scale_px);

    /// What the points look like from the part when they are tilted about an axis across the line
    /// of sight: wherever there is a second minimum, one of these leads there.
    [[nodiscard]] std::vector<Similarity> tilted() const;

    /// Twice the robust cost at the minimum next to `similarity`, which is moved there, as are the
    /// points; infinite where there is none. With `uncertainty`, sets it: what one standard
    /// deviation of the similarity moves cameras by.
    double minimise(Similarity& similarity, std::vector<Eigen::Vector3d>& points,
                    PoseShift* uncertainty) const;

    [[nodiscard]] const std::vector<Eigen::Vector3d>& points() const { return points_; }

    /// Of all cameras, when those of the part go where the similarity has them.
    [[nodiscard]] PoseShift shift_by(const Similarity& similarity) const;

    /// The capture with the part where the similarity has it, and what it sees alone with it;
    /// `shared` are the places of the shared points `indices`.
    [[nodiscard]] Capture moved_by(const Similarity& similarity,
                                   const std::vector<std::size_t>& indices,
                                   const std::vector<Eigen::Vector3d>& shared) const;

 private:
    void add_observations(ceres::Problem& problem, Similarity& similarity,
                          std::vector<Eigen::Vector3d>& points, ceres::LossFunction& robust) const;
    [[nodiscard]] PoseShift uncertainty_of(ceres::Problem& problem, const Similarity& at) const;
    [[nodiscard]] Rigid3 through(const Similarity& similarity, const Rigid3& cam_from_world) const;
    [[nodiscard]] Eigen::Vector3d middle_of_part() const;

    const Capture& capture_;
    const std::vector<char>& is_in_part_;
    double scale_px_;
    bool has_size_ = true;
    Eigen::Vector3d centre_ = Eigen::Vector3d::Zero();
    std::vector<Eigen::Vector3d> points_;
    std::vector<const std::vector<Observation>*> tracks_;
};

}  // namespace lumi
