#pragma once

#include <ceres/ceres.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "calib/capture/camera.h"

namespace lumi {

/// What a view saw of a point, as a pinhole of the same focal length would have.
struct StraightSight {
    Eigen::Vector2d straight_px;         ///< From the principal point.
    Eigen::Matrix2d pixel_per_straight;  ///< How errors there show in the picture.
    double focal_px;
    double time;  ///< When its row was read: -0.5 for the first to 0.5 for the last.
};

/// Empty where the lens, far out, does not tell where it was.
inline std::optional<StraightSight> straight_sight(const Camera& camera,
                                                   const Eigen::Vector2d& pixel) {
    constexpr double kStep = 1e-4;
    constexpr double kFarOff_px = 0.1;
    const Eigen::Vector3d ray = unproject(camera, pixel);
    const auto again = project(camera, ray);
    if (!again || !((*again - pixel).norm() < kFarOff_px)) return std::nullopt;
    const double focal_px = focal_length_px(camera).mean();
    StraightSight sight{focal_px * ray.head<2>(), Eigen::Matrix2d::Identity(), focal_px,
                        pixel.y() / camera.height_px - 0.5};
    for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
        const auto before = project(camera, ray - step);
        const auto behind = project(camera, ray + step);
        if (!before || !behind) return std::nullopt;
        sight.pixel_per_straight.col(axis) = (*behind - *before) / (2 * kStep * focal_px);
    }
    return sight;
}

/// Parameter blocks: rotation and translation cam_from_world at the middle row, the turn and the
/// crop of the view, the logarithm of the focal length over that of the lens, two coefficients of
/// the radial distortion that it lacks, the place of its principal point (px, from where the lens
/// has it), the point.
class SightCost {
 public:
    explicit SightCost(const StraightSight& seen) : seen_(seen) {}

    template <class T>
    bool operator()(const T* rotation, const T* translation, const T* turn, const T* crop,
                    const T* zoom, const T* radial, const T* middle, const T* point,
                    T* residual) const {
        using std::exp;
        using Vector2 = Eigen::Matrix<T, 2, 1>;
        using Vector3 = Eigen::Matrix<T, 3, 1>;
        const Vector3 at_middle =
            Eigen::Map<const Eigen::Quaternion<T>>(rotation) * Eigen::Map<const Vector3>(point) +
            Eigen::Map<const Vector3>(translation);
        const Vector3 turned =
            at_middle + T(seen_.time) * Eigen::Map<const Vector3>(turn).cross(at_middle);
        if (!(turned.z() > T(1e-9))) return false;
        const T x = turned.x() / turned.z();
        const T y = turned.y() / turned.z();
        const T square = x * x + y * y;
        const T scale = T(seen_.focal_px) * exp(zoom[0] + crop[2]) *
                        (T(1) + square * (radial[0] + square * radial[1]));
        const Vector2 straight(scale * x + crop[0] + middle[0] - T(seen_.straight_px.x()),
                               scale * y + crop[1] + middle[1] - T(seen_.straight_px.y()));
        Eigen::Map<Vector2> in_picture(residual);
        in_picture = seen_.pixel_per_straight.template cast<T>() * straight;
        return true;
    }

 private:
    StraightSight seen_;
};

/// Holds values near zero.
template <int kValues>
class NearZero {
 public:
    using Weights = Eigen::Matrix<double, kValues, 1>;
    explicit NearZero(const Weights& weights) : weights_(weights) {}
    template <class T>
    bool operator()(const T* values, T* residual) const {
        for (int index = 0; index < kValues; ++index)
            residual[index] = T(weights_[index]) * values[index];
        return true;
    }

 private:
    Weights weights_;
};

/// Holds near zero what the views' turns have in common: their sum in the axes of the cameras, and
/// their sum in those of the world. Points and poses that are bent make up for either where
/// pictures are held alike (Albl, Sugimoto, Pajdla, Degeneracies in rolling shutter SfM, ECCV
/// 2016), and whatever a lens does that its model lacks passes for it; what hands do differs from
/// picture to picture.
class NothingInCommon final : public ceres::CostFunction {
 public:
    NothingInCommon(std::vector<Eigen::Matrix3d> world_from_cam, double weight)
        : world_from_cam_(std::move(world_from_cam)), weight_(weight) {
        set_num_residuals(6);
        mutable_parameter_block_sizes()->assign(world_from_cam_.size(), 3);
    }
    bool Evaluate(double const* const* turns, double* residuals,
                  double** jacobians) const override {
        using Jacobian = Eigen::Matrix<double, 6, 3, Eigen::RowMajor>;
        Eigen::Map<Eigen::Matrix<double, 6, 1>> sums(residuals);
        sums.setZero();
        for (std::size_t view = 0; view < world_from_cam_.size(); ++view) {
            Jacobian slope;
            slope << weight_ * Eigen::Matrix3d::Identity(), weight_ * world_from_cam_[view];
            sums += slope * Eigen::Map<const Eigen::Vector3d>(turns[view]);
            if (jacobians == nullptr || jacobians[view] == nullptr) continue;
            Eigen::Map<Jacobian> by_turn(jacobians[view]);
            by_turn = slope;
        }
        return true;
    }

 private:
    std::vector<Eigen::Matrix3d> world_from_cam_;
    double weight_;
};

}  // namespace lumi
