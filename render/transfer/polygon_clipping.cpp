#include "render/transfer/polygon_clipping.h"

namespace lumi {

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

}  // namespace lumi
