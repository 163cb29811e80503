#include "render/paths/path_through_views.h"

#include <algorithm>
#include <cmath>

#include "render/paths/photograph_eye.h"
#include "render/paths/pose_between.h"

namespace lumi {

std::vector<Eye> path_through_views(const Lumigraph& lumigraph, int count, int width_px,
                                    int height_px) {
    std::vector<Eye> eyes;
    for (const LumigraphView& view : lumigraph.views) eyes.push_back(eye_at(view));
    const Camera camera = fitted_to(eyes.front(), width_px, height_px).camera;
    std::vector<Eye> path;
    for (int i = 0; i < count; ++i) {
        const double along = count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
        const double place = along * static_cast<double>(eyes.size() - 1);
        const auto from = static_cast<std::size_t>(std::floor(place));
        const std::size_t to = std::min(from + 1, eyes.size() - 1);
        path.push_back({camera, pose_between(eyes[from].cam_from_world, eyes[to].cam_from_world,
                                             place - std::floor(place))});
    }
    return path;
}

}  // namespace lumi
