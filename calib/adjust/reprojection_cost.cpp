#include "calib/adjust/reprojection_cost.h"

#include <Eigen/Geometry>
#include <cmath>

#include "calib/capture/lens_distortion.h"

namespace lumi {
namespace {

using RowMajor2x3 = Eigen::Matrix<double, 2, 3, Eigen::RowMajor>;
using RowMajor2x7 = Eigen::Matrix<double, 2, 7, Eigen::RowMajor>;

/// A point at depth 1, bent by the lens, with its derivatives.
struct Bent {
    Eigen::Vector2d point;
    Eigen::Matrix2d by_point;
    Eigen::Matrix<double, 2, 8> by_distortion;  ///< In the order of the model's parameters.
};

/// distorted_brown with its derivatives.
Bent bent_by_brown(const Eigen::Vector2d& point, const BrownTerms<double>& k) {
    const double x = point.x();
    const double y = point.y();
    const double r2 = point.squaredNorm();
    const double p1 = k[2];
    const double p2 = k[3];
    const double inverse = 1 / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
    const double radial = (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) * inverse;
    const double by_r2 = (k[0] + r2 * (2 * k[1] + 3 * r2 * k[4]) -
                          radial * (k[5] + r2 * (2 * k[6] + 3 * r2 * k[7]))) *
                         inverse;
    Bent bent;
    bent.point = {x * radial + 2 * p1 * x * y + p2 * (r2 + 2 * x * x),
                  y * radial + p1 * (r2 + 2 * y * y) + 2 * p2 * x * y};
    const double mixed = 2 * (x * y * by_r2 + p1 * x + p2 * y);
    bent.by_point << radial + 2 * x * x * by_r2 + 2 * p1 * y + 6 * p2 * x, mixed, mixed,
        radial + 2 * y * y * by_r2 + 6 * p1 * y + 2 * p2 * x;
    const Eigen::Vector2d over = point * (r2 * inverse);
    const Eigen::Vector2d under = over * -radial;
    bent.by_distortion.col(0) = over;
    bent.by_distortion.col(1) = over * r2;
    bent.by_distortion.col(2) = Eigen::Vector2d(2 * x * y, r2 + 2 * y * y);
    bent.by_distortion.col(3) = Eigen::Vector2d(r2 + 2 * x * x, 2 * x * y);
    bent.by_distortion.col(4) = over * (r2 * r2);
    bent.by_distortion.col(5) = under;
    bent.by_distortion.col(6) = under * r2;
    bent.by_distortion.col(7) = under * (r2 * r2);
    return bent;
}

/// distorted_fisheye with its derivatives.
Bent bent_by_fisheye(const Eigen::Vector2d& point, const double* k) {
    Bent bent{point, Eigen::Matrix2d::Identity(), Eigen::Matrix<double, 2, 8>::Zero()};
    const double r2 = point.squaredNorm();
    if (!(r2 > 1e-16)) return bent;  // The root has no derivative at zero.
    const double r = std::sqrt(r2);
    const double angle = std::atan(r);
    const double t2 = angle * angle;
    const double factor = fisheye_radius(angle, k) / r;
    const double by_angle = 1 + t2 * (3 * k[0] + t2 * (5 * k[1] + t2 * (7 * k[2] + t2 * 9 * k[3])));
    bent.point = point * factor;
    bent.by_point = factor * Eigen::Matrix2d::Identity() +
                    (by_angle / (1 + r2) - factor) / r2 * point * point.transpose();
    double power = angle * t2 / r;
    for (int index = 0; index < 4; ++index) {
        bent.by_distortion.col(index) = point * power;
        power *= t2;
    }
    return bent;
}

template <LensModel model>
Bent bent_by(const Eigen::Vector2d& point, const double* k) {
    if constexpr (model == LensModel::kOpenCvFisheye) {
        return bent_by_fisheye(point, k);
    } else {
        return bent_by_brown(point, brown_terms<model>(k));
    }
}

/// The derivatives written out: several times as fast as automatic ones, which a test holds them
/// to.
template <LensModel model>
class ReprojectionCost final
    : public ceres::SizedCostFunction<2, static_cast<int>(parameter_count(model)), 7, 3> {
 public:
    explicit ReprojectionCost(const Eigen::Vector2d& seen_at) : seen_at_(seen_at) {}

    /// False when the point is not in front of the camera: Ceres then takes a shorter step.
    bool Evaluate(double const* const* blocks, double* residual,
                  double** jacobians) const override {
        const double* const lens = blocks[0];
        const Eigen::Map<const Eigen::Quaterniond> rotation(blocks[1]);
        const Eigen::Map<const Eigen::Vector3d> translation(blocks[1] + 4);
        const Eigen::Map<const Eigen::Vector3d> point(blocks[2]);
        const Eigen::Vector3d point_in_cam = rotation * point + translation;
        if (!(point_in_cam.z() > 1e-12)) return false;
        const double inverse_z = 1 / point_in_cam.z();
        const Eigen::Vector2d at_depth_one = point_in_cam.head<2>() * inverse_z;
        constexpr int kCentre = static_cast<int>(principal_point_index(model));
        const Bent bent = bent_by<model>(at_depth_one, lens + kCentre + 2);
        const Eigen::Vector2d focal(lens[0], lens[kCentre - 1]);
        residual[0] = focal.x() * bent.point.x() + lens[kCentre] - seen_at_.x();
        residual[1] = focal.y() * bent.point.y() + lens[kCentre + 1] - seen_at_.y();
        if (jacobians == nullptr) return true;

        RowMajor2x3 depth_one_by_cam;
        depth_one_by_cam << inverse_z, 0, -at_depth_one.x() * inverse_z, 0, inverse_z,
            -at_depth_one.y() * inverse_z;
        const RowMajor2x3 by_cam = focal.asDiagonal() * bent.by_point * depth_one_by_cam;
        if (jacobians[0] != nullptr) write_by_lens(bent, focal, jacobians[0]);
        if (jacobians[1] != nullptr) {
            Eigen::Map<RowMajor2x7> by_pose(jacobians[1]);
            by_pose.leftCols<4>().noalias() = by_cam * rotated_by_quaternion(rotation, point);
            by_pose.rightCols<3>() = by_cam;
        }
        if (jacobians[2] != nullptr) {
            Eigen::Map<RowMajor2x3> by_point(jacobians[2]);
            by_point.noalias() = by_cam * rotation.toRotationMatrix();
        }
        return true;
    }

 private:
    static void write_by_lens(const Bent& bent, const Eigen::Vector2d& focal, double* jacobian) {
        constexpr int kLens = static_cast<int>(parameter_count(model));
        constexpr int kCentre = static_cast<int>(principal_point_index(model));
        Eigen::Map<Eigen::Matrix<double, 2, kLens, Eigen::RowMajor>> by_lens(jacobian);
        by_lens.setZero();
        by_lens(0, 0) = bent.point.x();
        by_lens(1, kCentre - 1) = bent.point.y();
        by_lens(0, kCentre) = 1;
        by_lens(1, kCentre + 1) = 1;
        constexpr int kTerms = kLens - kCentre - 2;
        by_lens.template rightCols<kTerms>() =
            focal.asDiagonal() * bent.by_distortion.template leftCols<kTerms>();
    }

    /// Of q * p = p + 2 w (u x p) + 2 u x (u x p), for q = (u, w) of any length.
    static Eigen::Matrix<double, 3, 4> rotated_by_quaternion(
        const Eigen::Map<const Eigen::Quaterniond>& rotation,
        const Eigen::Map<const Eigen::Vector3d>& point) {
        const Eigen::Vector3d u = rotation.vec();
        const double w = rotation.w();
        Eigen::Matrix<double, 3, 4> by_quaternion;
        by_quaternion.leftCols<3>() = 2 * (u * point.transpose() - 2 * point * u.transpose());
        by_quaternion.leftCols<3>().diagonal().array() += 2 * u.dot(point);
        by_quaternion(0, 1) += 2 * w * point.z();
        by_quaternion(0, 2) -= 2 * w * point.y();
        by_quaternion(1, 0) -= 2 * w * point.z();
        by_quaternion(1, 2) += 2 * w * point.x();
        by_quaternion(2, 0) += 2 * w * point.y();
        by_quaternion(2, 1) -= 2 * w * point.x();
        by_quaternion.col(3) = 2 * u.cross(point);
        return by_quaternion;
    }

    Eigen::Vector2d seen_at_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> reprojection_cost(LensModel model,
                                                       const Eigen::Vector2d& seen_at) {
    return with_lens_model(model, [&](auto known) -> std::unique_ptr<ceres::CostFunction> {
        return std::make_unique<ReprojectionCost<known>>(seen_at);
    });
}

}  // namespace lumi
