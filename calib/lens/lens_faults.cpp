#include "calib/lens/lens_faults.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>

#include "calib/capture/lens_distortion.h"

namespace lumi {
namespace {

double distortion_term(const Camera& lens, std::size_t index) {
    const std::size_t at = first_distortion_parameter(lens.model) + index;
    return at < lens.parameters.size() ? lens.parameters[at] : 0.0;
}

/// Radius at depth 1 (or the angle, for a fisheye) after distortion, without tangential terms.
double bent_radius(const Camera& lens, double radius) {
    const double* terms = lens.parameters.data() + first_distortion_parameter(lens.model);
    if (lens.model == LensModel::kOpenCvFisheye) return fisheye_radius(radius, terms);
    return with_lens_model(lens.model, [&](auto model) {
        BrownTerms<double> brown = brown_terms<decltype(model)::value>(terms);
        constexpr std::size_t kFirstTangential = 2;
        brown[kFirstTangential] = brown[kFirstTangential + 1] = 0;
        return distorted_brown(Eigen::Vector2d(radius, 0), brown).x();
    });
}

bool is_one_to_one(const Camera& lens, double farthest) {
    constexpr double kStep = 0.005;
    constexpr double kMaxRadius = 20.0;
    double before = 0;
    for (double radius = kStep; radius < kMaxRadius; radius += kStep * (1 + radius)) {
        const double bent = bent_radius(lens, radius);
        if (!(bent > before)) return false;
        if (bent >= farthest) return true;
        before = bent;
    }
    return false;
}

/// Roots of x^3 + a x^2 + b x + c. With x = 1 / r^2 the polynomial 1 + a r^2 + b r^4 + c r^6 is
/// this one.
Eigen::Vector3cd roots(double a, double b, double c) {
    Eigen::Matrix3d companion = Eigen::Matrix3d::Zero();
    companion(1, 0) = companion(2, 1) = 1;
    companion.col(2) << -c, -b, -a;
    return companion.eigenvalues();
}

bool has_cancelled_pole(const Camera& lens, double farthest) {
    const auto k = [&](std::size_t index) { return distortion_term(lens, index); };
    const Eigen::Vector3cd zeros = roots(k(0), k(1), k(4));
    constexpr double kNear = 0.1;
    for (const std::complex<double>& pole : roots(k(5), k(6), k(7))) {
        if (std::abs(pole) * farthest * farthest < 1) continue;
        for (const std::complex<double>& zero : zeros) {
            if (std::abs(zero - pole) < kNear * std::abs(pole)) return true;
        }
    }
    return false;
}

}  // namespace

std::string lens_fault(const Camera& lens, double farthest) {
    if (!is_one_to_one(lens, farthest)) return "folds over within the picture";
    if (lens.model == LensModel::kFullOpenCv && has_cancelled_pole(lens, farthest)) {
        return "a pole and a zero of its distortion cancel";
    }
    return {};
}

}  // namespace lumi
