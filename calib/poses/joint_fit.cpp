#include "calib/poses/joint_fit.h"

#include <ceres/ceres.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "calib/adjust/quiet_solver.h"
#include "calib/work/cauchy_scale.h"

namespace lumi {
namespace {

/// Parameter blocks: rotation, shift and logarithm of the scale of the similarity, the point.
class CostInPart {
 public:
    CostInPart(const Rigid3& cam_from_world, const Eigen::Vector3d& centre,
               const Eigen::Vector2d& ray, double focal_px)
        : cam_from_world_(cam_from_world), centre_(centre), ray_(ray), focal_px_(focal_px) {}

    template <class T>
    bool operator()(const T* rotation, const T* shift, const T* log_scale, const T* point,
                    T* residual) const {
        using std::exp;
        using Vector3 = Eigen::Matrix<T, 3, 1>;
        const Vector3 centre = centre_.cast<T>();
        const Vector3 turned = Eigen::Map<const Eigen::Quaternion<T>>(rotation) *
                               Vector3(Eigen::Map<const Vector3>(point) - centre);
        const Vector3 moved =
            centre + exp(log_scale[0]) * turned + Eigen::Map<const Vector3>(shift);
        const Vector3 in_cam =
            cam_from_world_.rotation.cast<T>() * moved + cam_from_world_.translation.cast<T>();
        if (!(in_cam.z() > T(1e-9))) return false;
        residual[0] = T(focal_px_) * (in_cam.x() / in_cam.z() - T(ray_.x()));
        residual[1] = T(focal_px_) * (in_cam.y() / in_cam.z() - T(ray_.y()));
        return true;
    }

 private:
    Rigid3 cam_from_world_;
    Eigen::Vector3d centre_;
    Eigen::Vector2d ray_;
    double focal_px_;
};

/// The same for a view that is not in the part: by the point alone.
class CostOutside {
 public:
    explicit CostOutside(const CostInPart& cost) : cost_(cost) {}

    template <class T>
    bool operator()(const T* point, T* residual) const {
        const std::array<T, 4> rotation{T(0), T(0), T(0), T(1)};
        const std::array<T, 3> shift{T(0), T(0), T(0)};
        const T log_scale(0);
        return cost_(rotation.data(), shift.data(), &log_scale, point, residual);
    }

 private:
    CostInPart cost_;
};

std::shared_ptr<ceres::ParameterBlockOrdering> order_of(Similarity& similarity,
                                                        std::vector<Eigen::Vector3d>& points) {
    auto order = std::make_shared<ceres::ParameterBlockOrdering>();
    for (Eigen::Vector3d& point : points) order->AddElementToGroup(point.data(), 0);
    order->AddElementToGroup(similarity.rotation.coeffs().data(), 1);
    order->AddElementToGroup(similarity.shift.data(), 1);
    order->AddElementToGroup(&similarity.log_scale, 1);
    return order;
}

}  // namespace

JointFit::JointFit(const Capture& capture, const std::vector<char>& is_in_part,
                   const std::vector<std::size_t>& points, double scale_px)
    : capture_(capture), is_in_part_(is_in_part), scale_px_(scale_px) {
    const auto inside = std::count(is_in_part.begin(), is_in_part.end(), char{1});
    has_size_ = inside > 1 && inside + 1 < static_cast<std::ptrdiff_t>(is_in_part.size());
    for (const std::size_t index : points) {
        points_.push_back(capture.points[index].position_in_world);
        tracks_.push_back(&capture.points[index].track);
        centre_ += points_.back() / static_cast<double>(points.size());
    }
}

std::vector<Similarity> JointFit::tilted() const {
    constexpr int kAxes = 8;
    constexpr double kTilt_rad = std::numbers::pi / 4;
    const Eigen::Vector3d towards = (centre_ - middle_of_part()).normalized();
    const Eigen::Vector3d across = towards.unitOrthogonal();
    std::vector<Similarity> starts;
    for (int index = 0; index < kAxes; ++index) {
        const Eigen::AngleAxisd around(2 * std::numbers::pi * index / kAxes, towards);
        Similarity start;
        start.rotation = Eigen::AngleAxisd(kTilt_rad, around * across);
        starts.push_back(start);
    }
    return starts;
}

double JointFit::minimise(Similarity& similarity, std::vector<Eigen::Vector3d>& points,
                          PoseShift* uncertainty) const {
    ceres::Problem::Options ownership;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::CauchyLoss robust(scale_px_);
    ceres::Problem problem(ownership);
    add_observations(problem, similarity, points, robust);
    problem.SetManifold(similarity.rotation.coeffs().data(), new ceres::EigenQuaternionManifold);
    // How large a part of one camera is, nobody can see.
    if (!has_size_) problem.SetParameterBlockConstant(&similarity.log_scale);
    ceres::Solver::Options solver = quiet_solver_options();
    solver.linear_solver_type = ceres::DENSE_SCHUR;
    solver.linear_solver_ordering = order_of(similarity, points);
    solver.max_num_iterations = 100;
    ceres::Solver::Summary summary;
    ceres::Solve(solver, &problem, &summary);
    similarity.rotation.normalize();
    if (uncertainty != nullptr) *uncertainty = uncertainty_of(problem, similarity);
    return summary.IsSolutionUsable() ? 2 * summary.final_cost
                                      : std::numeric_limits<double>::infinity();
}

PoseShift JointFit::shift_by(const Similarity& similarity) const {
    NamedPoses moved;
    for (std::size_t index = 0; index < capture_.views.size(); ++index) {
        const View& view = capture_.views[index];
        moved[view.name] = is_in_part_[index] != 0 ? through(similarity, view.cam_from_world)
                                                   : view.cam_from_world;
    }
    return pose_shift(moved, named_poses(capture_));
}

Capture JointFit::moved_by(const Similarity& similarity, const std::vector<std::size_t>& indices,
                           const std::vector<Eigen::Vector3d>& shared) const {
    Capture moved = capture_;
    for (std::size_t index = 0; index < moved.views.size(); ++index) {
        Rigid3& pose = moved.views[index].cam_from_world;
        if (is_in_part_[index] != 0) pose = through(similarity, pose);
    }
    for (ScenePoint& point : moved.points) {
        const bool is_of_part =
            std::all_of(point.track.begin(), point.track.end(), [&](const auto& seen) {
                return is_in_part_[static_cast<std::size_t>(seen.view_index)] != 0;
            });
        if (!is_of_part) continue;
        point.position_in_world =
            centre_ + std::exp(-similarity.log_scale) *
                          (similarity.rotation.conjugate() *
                           (point.position_in_world - similarity.shift - centre_));
    }
    for (std::size_t index = 0; index < indices.size(); ++index) {
        moved.points[indices[index]].position_in_world = shared[index];
    }
    return moved;
}

void JointFit::add_observations(ceres::Problem& problem, Similarity& similarity,
                                std::vector<Eigen::Vector3d>& points,
                                ceres::LossFunction& robust) const {
    for (std::size_t index = 0; index < points.size(); ++index) {
        for (const Observation& seen : *tracks_[index]) {
            const auto view_index = static_cast<std::size_t>(seen.view_index);
            const View& view = capture_.views[view_index];
            const Camera& lens = camera_of(capture_, view);
            const CostInPart cost(view.cam_from_world, centre_,
                                  unproject(lens, seen.pixel).head<2>(),
                                  focal_length_px(lens).mean());
            if (is_in_part_[view_index] == 0) {
                problem.AddResidualBlock(
                    new ceres::AutoDiffCostFunction<CostOutside, 2, 3>(new CostOutside(cost)),
                    &robust, points[index].data());
            } else {
                problem.AddResidualBlock(new ceres::AutoDiffCostFunction<CostInPart, 2, 4, 3, 1, 3>(
                                             new CostInPart(cost)),
                                         &robust, similarity.rotation.coeffs().data(),
                                         similarity.shift.data(), &similarity.log_scale,
                                         points[index].data());
            }
        }
    }
}

/// Moves the part by one standard deviation along each principal direction of the covariance,
/// and sums the squares of what that does.
PoseShift JointFit::uncertainty_of(ceres::Problem& problem, const Similarity& at) const {
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const PoseShift unknown{static_cast<int>(capture_.views.size()), kInfinite, kInfinite};
    std::vector<const double*> blocks{at.rotation.coeffs().data(), at.shift.data()};
    if (has_size_) blocks.push_back(&at.log_scale);
    const Eigen::Index unknowns = has_size_ ? 7 : 6;
    ceres::Covariance::Options options;
    options.algorithm_type = ceres::SPARSE_QR;
    ceres::Covariance estimator(options);
    Eigen::MatrixXd covariance(unknowns, unknowns);
    if (!estimator.Compute(blocks, &problem) ||
        !estimator.GetCovarianceMatrixInTangentSpace(blocks, covariance.data()) ||
        !covariance.allFinite()) {
        return unknown;
    }
    const double noise_px = scale_px_ / kCauchyScalePerSigma;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(covariance);
    PoseShift total{static_cast<int>(capture_.views.size()), 0, 0};
    for (Eigen::Index axis = 0; axis < unknowns; ++axis) {
        const Eigen::VectorXd step = noise_px *
                                     std::sqrt(std::max(0.0, solver.eigenvalues()[axis])) *
                                     solver.eigenvectors().col(axis);
        Similarity moved = at;
        // The manifold's tangent is half the angle.
        const Eigen::Vector3d turn = 2 * step.head<3>();
        if (turn.norm() > 0) {
            moved.rotation =
                Eigen::Quaterniond(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * at.rotation;
        }
        moved.shift += step.segment<3>(3);
        if (has_size_) moved.log_scale += step[6];
        const PoseShift shift = shift_by(moved);
        total.position_share = std::hypot(total.position_share, shift.position_share);
        total.rotation_deg = std::hypot(total.rotation_deg, shift.rotation_deg);
    }
    return total;
}

Rigid3 JointFit::through(const Similarity& similarity, const Rigid3& cam_from_world) const {
    const Eigen::Quaterniond rotation = cam_from_world.rotation * similarity.rotation;
    const Eigen::Vector3d of_centre = cam_from_world * (centre_ + similarity.shift);
    return {rotation, std::exp(-similarity.log_scale) * of_centre - rotation * centre_};
}

/// The mean place of the part's cameras, each as often as it sees the points.
Eigen::Vector3d JointFit::middle_of_part() const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0;
    for (const std::vector<Observation>* track : tracks_) {
        for (const Observation& seen : *track) {
            const auto view = static_cast<std::size_t>(seen.view_index);
            if (is_in_part_[view] == 0) continue;
            sum += centre_in_world(capture_.views[view].cam_from_world);
            count += 1;
        }
    }
    return sum / std::max(1.0, count);
}

}  // namespace lumi
