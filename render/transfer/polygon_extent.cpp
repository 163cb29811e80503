#include "render/transfer/polygon_extent.h"

namespace lumi {

double area_px2(const std::vector<Eigen::Vector2d>& corners_px) {
    double doubled = 0;
    for (std::size_t i = 2; i < corners_px.size(); ++i)
        doubled +=
            doubled_area_px2(corners_px[i - 1] - corners_px[0], corners_px[i] - corners_px[0]);
    return 0.5 * doubled;
}

Eigen::AlignedBox2d bounding_box(std::span<const Eigen::Vector2d> corners) {
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& corner : corners) box.extend(corner);
    return box;
}

}  // namespace lumi
