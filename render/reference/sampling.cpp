#include "render/reference/sampling.h"

#include <algorithm>
#include <cmath>

namespace lumi {
namespace {

Eigen::Vector3d value_of(const Rgb8& pixel) {
    return {static_cast<double>(pixel.r), static_cast<double>(pixel.g),
            static_cast<double>(pixel.b)};
}

double value_of(float pixel) { return pixel; }

template <class Value, class Pixel>
Value interpolated(const Image<Pixel>& image, const Eigen::Vector2d& pixel) {
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
    return (1 - to_bottom) * upper + to_bottom * lower;
}

}  // namespace

Eigen::Vector3d bilinear(const ColorImage& image, const Eigen::Vector2d& pixel) {
    return interpolated<Eigen::Vector3d>(image, pixel);
}

double bilinear(const FloatImage& image, const Eigen::Vector2d& pixel) {
    return interpolated<double>(image, pixel);
}

double nearest(const FloatImage& image, const Eigen::Vector2d& pixel) {
    return static_cast<double>(
        image(static_cast<int>(std::clamp(pixel.x(), 0.0, image.width() - 1.0)),
              static_cast<int>(std::clamp(pixel.y(), 0.0, image.height() - 1.0))));
}

}  // namespace lumi
