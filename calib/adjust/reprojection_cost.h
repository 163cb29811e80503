#pragma once

#include <ceres/ceres.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>

#include "calib/capture/camera.h"

namespace lumi {

/// The lens models again, to be differentiated: `camera.cpp` states them in plain doubles, and a
/// test holds both to the same pixels.

/// Brown's radial and tangential distortion at depth 1, with OpenCV's rational radial factor.
template <class T>
Eigen::Matrix<T, 2, 1> distorted_brown(const Eigen::Matrix<T, 2, 1>& point, const T& k1,
                                       const T& k2, const T& p1, const T& p2, const T& k3,
                                       const T& k4, const T& k5, const T& k6) {
    const T x = point.x();
    const T y = point.y();
    const T r2 = x * x + y * y;
    const T radial =
        (T(1) + r2 * (k1 + r2 * (k2 + r2 * k3))) / (T(1) + r2 * (k4 + r2 * (k5 + r2 * k6)));
    return {x * radial + T(2) * p1 * x * y + p2 * (r2 + T(2) * x * x),
            y * radial + p1 * (r2 + T(2) * y * y) + T(2) * p2 * x * y};
}

/// Equidistant fisheye (Kannala and Brandt, PAMI 2006) at depth 1.
template <class T>
Eigen::Matrix<T, 2, 1> distorted_fisheye(const Eigen::Matrix<T, 2, 1>& point, const T* k) {
    using std::atan;
    using std::sqrt;
    const T r2 = point.squaredNorm();
    if (!(r2 > T(1e-16))) return point;  // The root has no derivative at zero.
    const T r = sqrt(r2);
    const T theta = atan(r);
    const T t2 = theta * theta;
    const T bent = theta * (T(1) + t2 * (k[0] + t2 * (k[1] + t2 * (k[2] + t2 * k[3]))));
    return point * (bent / r);
}

/// How many parameters the model has.
constexpr std::size_t lens_size(LensModel model) {
    switch (model) {
        case LensModel::kSimplePinhole:
            return 3;
        case LensModel::kPinhole:
        case LensModel::kSimpleRadial:
            return 4;
        case LensModel::kRadial:
            return 5;
        case LensModel::kOpenCv:
        case LensModel::kOpenCvFisheye:
            return 8;
        case LensModel::kFullOpenCv:
            return 12;
    }
    return 0;
}

/// Index of cx among the parameters.
constexpr int principal_point_index(LensModel model) {
    return model == LensModel::kSimplePinhole || model == LensModel::kSimpleRadial ||
                   model == LensModel::kRadial
               ? 1
               : 2;
}

/// Pixel of a point at depth 1, for the parameters of `model` in COLMAP's order.
template <LensModel model, class T>
Eigen::Matrix<T, 2, 1> pixel_of(const T* lens, const Eigen::Matrix<T, 2, 1>& point) {
    constexpr int kCentre = principal_point_index(model);
    const T* const k = lens + kCentre + 2;
    const T zero(0);
    Eigen::Matrix<T, 2, 1> bent = point;
    if constexpr (model == LensModel::kSimpleRadial) {
        bent = distorted_brown(point, k[0], zero, zero, zero, zero, zero, zero, zero);
    } else if constexpr (model == LensModel::kRadial) {
        bent = distorted_brown(point, k[0], k[1], zero, zero, zero, zero, zero, zero);
    } else if constexpr (model == LensModel::kOpenCv) {
        bent = distorted_brown(point, k[0], k[1], k[2], k[3], zero, zero, zero, zero);
    } else if constexpr (model == LensModel::kFullOpenCv) {
        bent = distorted_brown(point, k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7]);
    } else if constexpr (model == LensModel::kOpenCvFisheye) {
        bent = distorted_fisheye(point, k);
    }
    return {lens[0] * bent.x() + lens[kCentre], lens[kCentre - 1] * bent.y() + lens[kCentre + 1]};
}

/// Pixel where a point is predicted minus pixel where it was seen, under a lens model known only at
/// run time, with its derivatives. Parameter blocks: lens, cam_from_world (PoseBlock), point in
/// world. There is no value when the point is not in front of the camera.
[[nodiscard]] std::unique_ptr<ceres::CostFunction> reprojection_cost(
    LensModel model, const Eigen::Vector2d& seen_at);

}  // namespace lumi
