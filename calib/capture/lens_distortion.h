#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

#include "calib/capture/lens_model.h"

namespace lumi {

/// The terms of Brown's distortion in the order of OpenCV: k1, k2, p1, p2, k3, k4, k5, k6.
template <class T>
using BrownTerms = std::array<T, 8>;

/// The first terms are the model's parameters from `k` on; the others are 0.
template <LensModel model, class T>
BrownTerms<T> brown_terms(const T* k) {
    BrownTerms<T> terms;
    terms.fill(T(0));
    std::copy_n(k, parameter_count(model) - first_distortion_parameter(model), terms.begin());
    return terms;
}

/// Radial and tangential distortion of a point at depth 1 (Brown 1971), with OpenCV's rational
/// radial factor.
template <class T>
Eigen::Matrix<T, 2, 1> distorted_brown(const Eigen::Matrix<T, 2, 1>& point,
                                       const BrownTerms<T>& terms) {
    const auto& [k1, k2, p1, p2, k3, k4, k5, k6] = terms;
    const T x = point.x();
    const T y = point.y();
    const T r2 = x * x + y * y;
    const T radial =
        (T(1) + r2 * (k1 + r2 * (k2 + r2 * k3))) / (T(1) + r2 * (k4 + r2 * (k5 + r2 * k6)));
    return {x * radial + T(2) * p1 * x * y + p2 * (r2 + T(2) * x * x),
            y * radial + p1 * (r2 + T(2) * y * y) + T(2) * p2 * x * y};
}

/// Image radius of an equidistant fisheye at an angle from its axis (Kannala and Brandt, PAMI
/// 2006).
template <class T>
T fisheye_radius(const T& angle, const T* k) {
    const T square = angle * angle;
    return angle * (T(1) + square * (k[0] + square * (k[1] + square * (k[2] + square * k[3]))));
}

/// A point at depth 1 where an equidistant fisheye shows it.
template <class T>
Eigen::Matrix<T, 2, 1> distorted_fisheye(const Eigen::Matrix<T, 2, 1>& point, const T* k) {
    using std::atan;
    using std::sqrt;
    const T r2 = point.squaredNorm();
    if (!(r2 > T(1e-16))) return point;  // The root has no derivative at zero.
    const T r = sqrt(r2);
    return point * (fisheye_radius(T(atan(r)), k) / r);
}

/// A point at depth 1 as the lens bends it; `k`: the model's parameters behind the principal point.
/// T is double, or a number that carries derivatives.
template <LensModel model, class T>
Eigen::Matrix<T, 2, 1> distorted(const Eigen::Matrix<T, 2, 1>& point, const T* k) {
    if constexpr (model == LensModel::kOpenCvFisheye) {
        return distorted_fisheye(point, k);
    } else if constexpr (parameter_count(model) == first_distortion_parameter(model)) {
        return point;
    } else {
        return distorted_brown(point, brown_terms<model>(k));
    }
}

/// Pixel of a point at depth 1, for the parameters of `model` in COLMAP's order.
template <LensModel model, class T>
Eigen::Matrix<T, 2, 1> pixel_of(const T* lens, const Eigen::Matrix<T, 2, 1>& point) {
    constexpr std::size_t kCentre = principal_point_index(model);
    const Eigen::Matrix<T, 2, 1> bent =
        distorted<model>(point, lens + first_distortion_parameter(model));
    return {lens[0] * bent.x() + lens[kCentre], lens[kCentre - 1] * bent.y() + lens[kCentre + 1]};
}

}  // namespace lumi
