#include "calib/boards/board_pose.h"

#include <ceres/jet.h>
#include <ceres/tiny_solver.h>

#include <Eigen/Dense>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "calib/capture/rigid3.h"

namespace lumi {
namespace {

constexpr std::size_t kLeastPoints = 4;
constexpr int kMaxIterations = 40;

Eigen::Vector2d on_board(const BoardPoint& point, double size_per_pitch) {
    return point.place + size_per_pitch * point.along_size;
}

/// Direction a pixel is seen in, by the lens without its distortion.
Eigen::Vector3d viewing_ray(const Camera& lens, const Eigen::Vector2d& px) {
    const Eigen::Vector2d offset =
        (px - principal_point_px(lens)).cwiseQuotient(focal_length_px(lens));
    if (lens.model != LensModel::kOpenCvFisheye) return offset.homogeneous().normalized();
    const double angle = std::min(offset.norm(), std::numbers::pi);
    if (angle < 1e-9) return Eigen::Vector3d::UnitZ();
    const Eigen::Vector2d sideways = offset / offset.norm() * std::sin(angle);
    return {sideways.x(), sideways.y(), std::cos(angle)};
}

/// Homography from the board's plane to viewing rays (direct linear transformation), signed so
/// that points lie along their rays and not behind.
std::optional<Eigen::Matrix3d> ray_homography(const BoardView& view, const Camera& lens,
                                              double size_per_pitch) {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const BoardPoint& point : view.points) mean += on_board(point, size_per_pitch);
    mean /= static_cast<double>(view.points.size());
    double spread = 0;
    for (const BoardPoint& point : view.points) {
        spread += (on_board(point, size_per_pitch) - mean).norm();
    }
    spread /= static_cast<double>(view.points.size());
    if (!(spread > 0)) return std::nullopt;
    Eigen::Matrix3d normalised_from_board = Eigen::Matrix3d::Identity();
    normalised_from_board.topLeftCorner<2, 2>() /= spread;
    normalised_from_board.topRightCorner<2, 1>() = -mean / spread;

    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(9, 9);
    for (const BoardPoint& point : view.points) {
        const Eigen::Vector3d from =
            normalised_from_board * on_board(point, size_per_pitch).homogeneous();
        const Eigen::Vector3d ray = viewing_ray(lens, point.px);
        Eigen::Matrix3d cross;
        cross << 0, -ray.z(), ray.y(), ray.z(), 0, -ray.x(), -ray.y(), ray.x(), 0;
        Eigen::Matrix<double, 3, 9> rows;
        for (int column = 0; column < 3; ++column) {
            rows.middleCols<3>(3 * column) = from(column) * cross;
        }
        normal += rows.transpose() * rows;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(normal);
    if (!(solver.eigenvalues()(1) > 1e-12 * solver.eigenvalues()(8))) return std::nullopt;
    const Eigen::Matrix<double, 9, 1> solution = solver.eigenvectors().col(0);
    Eigen::Matrix3d homography = Eigen::Map<const Eigen::Matrix3d>(solution.data());
    homography = homography * normalised_from_board;
    double along = 0;
    for (const BoardPoint& point : view.points) {
        along += viewing_ray(lens, point.px)
                     .dot(homography * on_board(point, size_per_pitch).homogeneous());
    }
    return along < 0 ? Eigen::Matrix3d(-homography) : homography;
}

BoardPose pose_from(const Eigen::Matrix3d& rotation, const Eigen::Vector3d& translation) {
    BoardPose pose{};
    // Ceres takes rotations column by column, as Eigen stores them.
    ceres::RotationMatrixToAngleAxis(rotation.data(), pose.data());
    Eigen::Map<Eigen::Vector3d>(pose.data() + 3) = translation;
    return pose;
}

BoardPose pose_of_homography(const Eigen::Matrix3d& homography) {
    const double scale = 0.5 * (homography.col(0).norm() + homography.col(1).norm());
    Eigen::Matrix3d nearly;
    nearly << homography.col(0) / scale, homography.col(1) / scale,
        homography.col(0).cross(homography.col(1)) / (scale * scale);
    const Eigen::JacobiSVD<Eigen::Matrix3d> svd(nearly, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Eigen::Matrix3d rotation = svd.matrixU() * svd.matrixV().transpose();
    if (rotation.determinant() < 0) {
        rotation =
            svd.matrixU() * Eigen::Vector3d(1, 1, -1).asDiagonal() * svd.matrixV().transpose();
    }
    return pose_from(rotation, homography.col(2) / scale);
}

Eigen::Matrix3d rotation_of(const BoardPose& pose) {
    Eigen::Matrix3d rotation;
    ceres::AngleAxisToRotationMatrix(pose.data(), rotation.data());
    return rotation;
}

Eigen::Vector3d middle_in_cam(const BoardView& view, double size_per_pitch, const BoardPose& pose) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    for (const BoardPoint& point : view.points) middle += on_board(point, size_per_pitch);
    middle /= static_cast<double>(view.points.size());
    return rotation_of(pose).leftCols<2>() * middle +
           Eigen::Map<const Eigen::Vector3d>(pose.data() + 3);
}

/// The other pose that looks alike from afar: the normal mirrored at the line of sight.
BoardPose mirrored(const BoardView& view, double size_per_pitch, const BoardPose& pose) {
    const Eigen::Vector3d middle = middle_in_cam(view, size_per_pitch, pose);
    const Eigen::Vector3d sight = middle.normalized();
    const Eigen::Matrix3d rotation = rotation_of(pose);
    const Eigen::Vector3d normal = rotation.col(2);
    const Eigen::Vector3d other = 2 * sight.dot(normal) * sight - normal;
    const Eigen::Matrix3d turn = turn_between(normal, other).toRotationMatrix();
    const Eigen::Vector3d translation = Eigen::Map<const Eigen::Vector3d>(pose.data() + 3);
    return pose_from(turn * rotation, middle + turn * (translation - middle));
}

/// Residuals of a whole view and their derivatives by the pose, for the small solver: one type for
/// all lenses, because each solver costs seconds of compiling.
class ViewResiduals {
 public:
    using Scalar = double;
    enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = 6 };

    ViewResiduals(const BoardView& view, const Camera& lens, double size_per_pitch)
        : view_(view), lens_(lens), size_(size_per_pitch) {}

    /// `jacobian` is column by column, or null.
    bool operator()(const double* pose, double* residuals, double* jacobian) const {
        bool is_seen = true;
        with_lens_model(lens_.model, [&](auto constant) {
            is_seen = differentiate<decltype(constant)::value>(pose, residuals, jacobian);
        });
        return is_seen;
    }
    [[nodiscard]] int NumResiduals() const { return 2 * static_cast<int>(view_.points.size()); }

 private:
    template <LensModel model>
    bool differentiate(const double* pose, double* residuals, double* jacobian) const {
        using Jet = ceres::Jet<double, NUM_PARAMETERS>;
        std::array<Jet, parameter_count(model)> lens;
        for (std::size_t index = 0; index < lens.size(); ++index) {
            lens[index] = Jet(lens_.parameters[index]);
        }
        std::array<Jet, NUM_PARAMETERS> pose_with_derivatives;
        for (int index = 0; index < NUM_PARAMETERS; ++index) {
            pose_with_derivatives[static_cast<std::size_t>(index)] = Jet(pose[index], index);
        }
        const Jet size(size_);
        for (std::size_t point = 0; point < view_.points.size(); ++point) {
            std::array<Jet, 2> offset;
            if (!BoardPointCost<model>(view_.points[point])(
                    lens.data(), &size, pose_with_derivatives.data(), offset.data())) {
                return false;
            }
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const std::size_t row = 2 * point + axis;
                residuals[row] = offset[axis].a;
                for (int column = 0; jacobian != nullptr && column < NUM_PARAMETERS; ++column) {
                    jacobian[static_cast<std::size_t>(column * NumResiduals()) + row] =
                        offset[axis].v[column];
                }
            }
        }
        return true;
    }

    const BoardView& view_;
    const Camera& lens_;
    double size_;
};

double rms_px(const BoardView& view, const Camera& lens, double size_per_pitch,
              const BoardPose& pose) {
    double sum = 0;
    const std::vector<Eigen::Vector2d> predicted = predicted_px(view, lens, size_per_pitch, pose);
    for (std::size_t index = 0; index < predicted.size(); ++index) {
        sum += (predicted[index] - view.points[index].px).squaredNorm();
    }
    const double rms = std::sqrt(sum / static_cast<double>(view.points.size()));
    return std::isfinite(rms) ? rms : std::numeric_limits<double>::infinity();
}

SolvedBoardPose refined(const BoardView& view, const Camera& lens, double size_per_pitch,
                        const BoardPose& start, int max_iterations) {
    BoardPose pose = start;
    const ViewResiduals residuals(view, lens, size_per_pitch);
    ceres::TinySolver<ViewResiduals> solver;
    solver.options.max_num_iterations = max_iterations;
    Eigen::Map<Eigen::Matrix<double, 6, 1>> parameters(pose.data());
    Eigen::Matrix<double, 6, 1> solution = parameters;
    if (std::isfinite(rms_px(view, lens, size_per_pitch, pose))) {
        solver.Solve(residuals, &solution);
    }
    parameters = solution;
    return {pose, rms_px(view, lens, size_per_pitch, pose)};
}

}  // namespace

std::vector<Eigen::Vector2d> predicted_px(const BoardView& view, const Camera& lens,
                                          double size_per_pitch, const BoardPose& cam_from_board,
                                          const BoardBow& bow) {
    std::vector<Eigen::Vector2d> predicted;
    const BoardFrame frame = frame_of(view);
    with_lens_model(lens.model, [&](auto constant) {
        constexpr LensModel kModel = decltype(constant)::value;
        for (const BoardPoint& point : view.points) {
            Eigen::Vector2d residual;
            const bool is_seen = BoardPointCost<kModel>(point, frame)(
                lens.parameters.data(), &size_per_pitch, cam_from_board.data(), bow.data(),
                residual.data());
            predicted.push_back(
                is_seen ? Eigen::Vector2d(residual + point.px)
                        : Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN()));
        }
    });
    return predicted;
}

std::optional<SolvedBoardPose> rough_board_pose(const BoardView& view, const Camera& lens,
                                                double size_per_pitch) {
    if (view.points.size() < kLeastPoints) return std::nullopt;
    const auto homography = ray_homography(view, lens, size_per_pitch);
    if (!homography || !homography->allFinite()) return std::nullopt;
    constexpr int kFewIterations = 6;
    return refined(view, lens, size_per_pitch, pose_of_homography(*homography), kFewIterations);
}

std::optional<SolvedBoardPose> solve_board_pose(const BoardView& view, const Camera& lens,
                                                double size_per_pitch,
                                                const std::optional<BoardPose>& start) {
    if (view.points.size() < kLeastPoints) return std::nullopt;
    if (start) return refined(view, lens, size_per_pitch, *start, kMaxIterations);
    const auto homography = ray_homography(view, lens, size_per_pitch);
    if (!homography || !homography->allFinite()) return std::nullopt;
    const SolvedBoardPose first =
        refined(view, lens, size_per_pitch, pose_of_homography(*homography), kMaxIterations);
    const SolvedBoardPose second =
        refined(view, lens, size_per_pitch, mirrored(view, size_per_pitch, first.cam_from_board),
                kMaxIterations);
    const SolvedBoardPose& better = second.rms_px < first.rms_px ? second : first;
    if (!std::isfinite(better.rms_px)) return std::nullopt;
    return better;
}

double board_tilt_deg(const BoardView& view, double size_per_pitch,
                      const BoardPose& cam_from_board) {
    const Eigen::Vector3d sight = middle_in_cam(view, size_per_pitch, cam_from_board).normalized();
    const double cosine = std::abs(rotation_of(cam_from_board).col(2).dot(sight));
    return std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
}

}  // namespace lumi
