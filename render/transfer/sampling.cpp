#include "render/transfer/sampling.h"

#include <algorithm>
#include <cmath>

namespace lumi {

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
