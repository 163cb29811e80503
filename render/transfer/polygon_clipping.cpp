#include "render/transfer/polygon_clipping.h"

namespace lumi {

std::vector<Eigen::Vector2d> picture_corners_px(const Camera& camera) {
    const double width = camera.width_px;
    const double height = camera.height_px;
    return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& corners,
                                     const Eigen::Vector3d& line) {
    std::vector<Eigen::Vector2d> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d& from = corners[i];
        const Eigen::Vector2d& to = corners[(i + 1) % corners.size()];
        const double at_from = line.head<2>().dot(from) + line.z();
        const double at_to = line.head<2>().dot(to) + line.z();
        if (at_from >= 0) kept.push_back(from);
        if ((at_from >= 0) != (at_to >= 0))
            kept.push_back(from + (to - from) * (at_from / (at_from - at_to)));
    }
    return kept;
}

std::vector<Eigen::Vector2d> clipped_between(const std::vector<Eigen::Vector2d>& corners,
                                             Eigen::Index axis, double low, double high) {
    Eigen::Vector3d from_low(0, 0, -low);
    Eigen::Vector3d to_high(0, 0, high);
    from_low[axis] = 1;
    to_high[axis] = -1;
    return clipped(clipped(corners, from_low), to_high);
}

std::vector<Eigen::Vector2d> clipped(const std::vector<Eigen::Vector2d>& corners,
                                     const Eigen::AlignedBox2d& box) {
    return clipped_between(clipped_between(corners, 1, box.min().y(), box.max().y()), 0,
                           box.min().x(), box.max().x());
}

}  // namespace lumi
