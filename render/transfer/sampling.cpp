#include "render/transfer/sampling.h"

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

double bilinear_to_zero(const GrayImage& image, const Eigen::Vector2d& pixel) {
    const double x = std::clamp(pixel.x() - 0.5, -1.0, static_cast<double>(image.width()));
    const double y = std::clamp(pixel.y() - 0.5, -1.0, static_cast<double>(image.height()));
    const int left = static_cast<int>(std::floor(x));
    const int top = static_cast<int>(std::floor(y));
    const auto value = [&](int column, int row) {
        return image.contains(column, row) ? static_cast<double>(image(column, row)) : 0.0;
    };
    return std::lerp(std::lerp(value(left, top), value(left + 1, top), x - left),
                     std::lerp(value(left, top + 1), value(left + 1, top + 1), x - left), y - top);
}

double nearest(const FloatImage& image, const Eigen::Vector2d& pixel) {
    return static_cast<double>(
        image(static_cast<int>(std::clamp(pixel.x(), 0.0, image.width() - 1.0)),
              static_cast<int>(std::clamp(pixel.y(), 0.0, image.height() - 1.0))));
}

}  // namespace lumi
