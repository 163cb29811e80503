#include "pipeline/evaluate/opponent_color.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "calib/pictures/srgb_curve.h"

namespace lumi {
namespace {

/// Linear RGB to XYZ over the white point, so that white is (1, 1, 1): from the chromaticities of
/// IEC 61966-2-1.
const Eigen::Matrix3f& relative_xyz_from_linear() {
    static const Eigen::Matrix3f matrix = [] {
        Eigen::Matrix3d xyz;
        xyz << 10135552.0 / 24577794.0, 8788810.0 / 24577794.0, 4435075.0 / 24577794.0,
            2613072.0 / 12288897.0, 8788810.0 / 12288897.0, 887015.0 / 12288897.0,
            1425312.0 / 73733382.0, 8788810.0 / 73733382.0, 70074185.0 / 73733382.0;
        const Eigen::Vector3d white = xyz * Eigen::Vector3d::Ones();
        return Eigen::Matrix3f((white.cwiseInverse().asDiagonal() * xyz).cast<float>());
    }();
    return matrix;
}

Eigen::Vector3f relative_xyz(const Color3& linear) {
    return relative_xyz_from_linear() * Eigen::Vector3f(linear[0], linear[1], linear[2]);
}

/// The cube root of CIE L*a*b* with its linear part near black.
float lab_root(float t) {
    constexpr float kDelta = 6.0F / 29.0F;
    if (t > kDelta * kDelta * kDelta) return std::cbrt(t);
    return t / (3.0F * kDelta * kDelta) + 4.0F / 29.0F;
}

}  // namespace

Color3 linear_from_srgb(const Rgb8& color) {
    const std::array<float, 256>& light = light_of_srgb_bytes();
    return {light[color.r], light[color.g], light[color.b]};
}

Color3 opponent_from_linear(const Color3& linear) {
    const Eigen::Vector3f xyz = relative_xyz(linear);
    return {116.0F * xyz.y() - 16.0F, 500.0F * (xyz.x() - xyz.y()), 200.0F * (xyz.y() - xyz.z())};
}

Color3 linear_from_opponent(const Color3& opponent) {
    static const Eigen::Matrix3f kLinearFromXyz = relative_xyz_from_linear().inverse();
    const float y = (opponent[0] + 16.0F) / 116.0F;
    const Eigen::Vector3f linear =
        kLinearFromXyz * Eigen::Vector3f(y + opponent[1] / 500.0F, y, y - opponent[2] / 200.0F);
    return {linear.x(), linear.y(), linear.z()};
}

Color3 clamped(const Color3& linear) {
    return {std::clamp(linear[0], 0.0F, 1.0F), std::clamp(linear[1], 0.0F, 1.0F),
            std::clamp(linear[2], 0.0F, 1.0F)};
}

Color3 hunt_adjusted_lab(const Color3& linear) {
    const Eigen::Vector3f root = relative_xyz(linear).unaryExpr(&lab_root);
    const float lightness = 116.0F * root.y() - 16.0F;
    const float hunt = 0.01F * lightness;
    return {lightness, hunt * 500.0F * (root.x() - root.y()),
            hunt * 200.0F * (root.y() - root.z())};
}

}  // namespace lumi
