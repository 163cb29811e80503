#include "pipeline/bench/shown_pixels.h"

#include <algorithm>

#include "calib/capture/inverse_depth_warp.h"
#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

/// Share of the inverse depth that neighbouring samples of one surface differ by at most.
constexpr double kOneSurface = 0.05;

/// Whether samples around the pixel are of one surface, and the point between them.
bool shows(const FloatImage& inverse_depth, const Eigen::Vector2d& pixel, double point) {
    const auto column = static_cast<int>(pixel.x());
    const auto row = static_cast<int>(pixel.y());
    double nearest = 0;
    double farthest = 1e30;
    for (int y = row - 1; y <= row + 1; ++y) {
        for (int x = column - 1; x <= column + 1; ++x) {
            if (!inverse_depth.contains(x, y)) return false;
            const auto sample = static_cast<double>(inverse_depth(x, y));
            nearest = std::max(nearest, sample);
            farthest = std::min(farthest, sample);
        }
    }
    return nearest - farthest <= kOneSurface * nearest && farthest <= point && point <= nearest;
}

}  // namespace

GrayImage shown_pixels(const FloatImage& z, const Eye& eye,
                       const std::vector<LumigraphView>& views) {
    std::vector<InverseDepthWarp> view_from_eye;
    view_from_eye.reserve(views.size());
    for (const LumigraphView& view : views) view_from_eye.push_back(warp_from(eye).to(view));
    GrayImage shown(z.width(), z.height(), 0);
    parallel_for(z.height(), 0, [&](int y) {
        for (int x = 0; x < z.width(); ++x) {
            const double q = z(x, y) > 0 ? 1 / static_cast<double>(z(x, y)) : 0.0;
            for (std::size_t i = 0; i < views.size() && shown(x, y) == 0; ++i) {
                const auto in_view = view_from_eye[i].at({x + 0.5, y + 0.5}, q);
                if (in_view && is_inside(views[i].camera, in_view->pixel) &&
                    shows(views[i].depth.inverse_depth, in_view->pixel, in_view->inverse_depth))
                    shown(x, y) = 255;
            }
        }
    });
    return shown;
}

}  // namespace lumi
