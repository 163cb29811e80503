#include "render/viewer/window_size.h"

#include <algorithm>

namespace lumi {

Eigen::Vector2i window_size_px(const Camera& camera) {
    const Eigen::Vector2d picture(camera.width_px, camera.height_px);
    constexpr double kMaxWidth_px = 1600;
    constexpr double kMaxHeight_px = 900;
    const double scale = std::min({1.0, kMaxWidth_px / picture.x(), kMaxHeight_px / picture.y()});
    const Eigen::Vector2i size = (scale * picture).array().round().matrix().cast<int>();
    return size.cwiseMax(Eigen::Vector2i(kLeastWindowWidth_px, kLeastWindowHeight_px));
}

}  // namespace lumi
