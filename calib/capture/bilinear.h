#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "calib/capture/image.h"

namespace lumi {

/// Bilinear interpolation between pixel centres, which lie at (x + 0.5, y + 0.5); beyond the
/// outermost centres the border is continued. `value_of` says what of a pixel is interpolated.
template <class Pixel, class ValueOf>
[[nodiscard]] auto interpolated(const Image<Pixel>& image, const Eigen::Vector2d& pixel,
                                const ValueOf& value_of) {
    using Value = decltype(value_of(image(0, 0)));
    const double x = std::clamp(pixel.x() - 0.5, 0.0, image.width() - 1.0);
    const double y = std::clamp(pixel.y() - 0.5, 0.0, image.height() - 1.0);
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int right = std::min(left + 1, image.width() - 1);
    const int bottom = std::min(top + 1, image.height() - 1);
    const double to_right = x - left;
    const double to_bottom = y - top;
    const Value upper =
        (1 - to_right) * value_of(image(left, top)) + to_right * value_of(image(right, top));
    const Value lower =
        (1 - to_right) * value_of(image(left, bottom)) + to_right * value_of(image(right, bottom));
    return Value((1 - to_bottom) * upper + to_bottom * lower);
}

[[nodiscard]] inline Eigen::Vector3d bilinear(const ColorImage& image,
                                              const Eigen::Vector2d& pixel) {
    return interpolated(
        image, pixel, [](const Rgb8& color) { return Eigen::Vector3d(color.r, color.g, color.b); });
}

[[nodiscard]] inline double bilinear(const FloatImage& image, const Eigen::Vector2d& pixel) {
    return interpolated(image, pixel, [](float value) { return static_cast<double>(value); });
}

}  // namespace lumi
