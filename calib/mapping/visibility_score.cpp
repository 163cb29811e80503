#include "calib/mapping/visibility_score.h"

#include <algorithm>
#include <vector>

namespace lumi {

double visibility_score(const Camera& camera, std::span<const Eigen::Vector2d> pixels) {
    constexpr int kFinest = 64;
    double score = 0;
    for (int cells = 2; cells <= kFinest; cells *= 2) {
        std::vector<char> is_hit(static_cast<std::size_t>(cells * cells), 0);
        for (const Eigen::Vector2d& pixel : pixels) {
            const int column =
                std::clamp(static_cast<int>(pixel.x() * cells / camera.width_px), 0, cells - 1);
            const int row =
                std::clamp(static_cast<int>(pixel.y() * cells / camera.height_px), 0, cells - 1);
            is_hit[static_cast<std::size_t>(row * cells + column)] = 1;
        }
        score += static_cast<double>(cells * cells) *
                 static_cast<double>(std::count(is_hit.begin(), is_hit.end(), char{1}));
    }
    return score;
}

}  // namespace lumi
