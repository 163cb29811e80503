#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace lumi {

/// Calls `visit(x, y, inverse_depth)` for the pixels of a picture of this size whose centres lie in
/// a triangle, wound either way. Corners have a `pixel` (continuous coordinates) and an
/// `inverse_depth`, which is affine in the picture, so that it is interpolated without division. A
/// pixel on an edge belongs to both triangles there. Rows are visited from the top, pixels of a row
/// from the left; of a triangle without area none.
template <class Corner, class Visit>
void for_each_pixel_in_triangle(const Corner& a, const Corner& b, const Corner& c, int width,
                                int height, const Visit& visit) {
    const Eigen::Vector2d ab = b.pixel - a.pixel;
    const Eigen::Vector2d ac = c.pixel - a.pixel;
    const double area = ab.x() * ac.y() - ab.y() * ac.x();
    if (area == 0) return;
    const Eigen::Vector2d low = a.pixel.cwiseMin(b.pixel).cwiseMin(c.pixel);
    const Eigen::Vector2d high = a.pixel.cwiseMax(b.pixel).cwiseMax(c.pixel);
    const auto first = [](double low_px, int size) {
        return static_cast<int>(std::clamp(std::ceil(low_px - 0.5), 0.0, 1.0 * size));
    };
    const auto end = [](double high_px, int size) {
        return static_cast<int>(std::clamp(std::floor(high_px - 0.5) + 1, 0.0, 1.0 * size));
    };
    const int begin_x = first(low.x(), width);
    const int end_x = end(high.x(), width);
    const int end_y = end(high.y(), height);
    for (int y = first(low.y(), height); y < end_y; ++y) {
        const double from_a_y = y + 0.5 - a.pixel.y();
        for (int x = begin_x; x < end_x; ++x) {
            const double from_a_x = x + 0.5 - a.pixel.x();
            const double wb = (from_a_x * ac.y() - from_a_y * ac.x()) / area;
            const double wc = (ab.x() * from_a_y - ab.y() * from_a_x) / area;
            const double wa = 1 - wb - wc;
            constexpr double kOnEdge = -1e-9;  // Rounding must not lose what lies between two.
            if (wa < kOnEdge || wb < kOnEdge || wc < kOnEdge) continue;
            visit(x, y, wa * a.inverse_depth + wb * b.inverse_depth + wc * c.inverse_depth);
        }
    }
}

}  // namespace lumi
