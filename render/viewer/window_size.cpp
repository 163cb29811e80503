#include "render/viewer/window_size.h"

#include <algorithm>

namespace lumi {

Eigen::Vector2i window_size_px(const Camera& camera) {
    const Eigen::Vector2d picture(camera.width_px, camera.height_px);
    constexpr double kMaxWidth_px = 1600;
    constexpr double kMaxHeight_px = 900;
    const double fitting = std::min({1.0, kMaxWidth_px / picture.x(), kMaxHeight_px / picture.y()});
    const double holding_panel =
        std::max(kLeastWindowWidth_px / picture.x(), kLeastWindowHeight_px / picture.y());
    const Eigen::Vector2d size = std::max(fitting, holding_panel) * picture;
    return size.cwiseMin(Eigen::Vector2d(kMaxWidth_px, kMaxHeight_px))
        .array()
        .round()
        .matrix()
        .cast<int>();
}

}  // namespace lumi
