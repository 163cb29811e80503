#include "meshing/depth_scene/views_far_apart.h"

#include "meshing/selection/farthest_first.h"

namespace lumi {

std::vector<int> views_far_apart(const DepthScene& scene, const std::vector<int>& candidates,
                                 int count) {
    const auto centre = [&](int candidate) {
        const int view = candidates[static_cast<std::size_t>(candidate)];
        return centre_in_world(scene.views[static_cast<std::size_t>(view)].cam_from_world);
    };
    std::vector<int> chosen =
        farthest_first(static_cast<int>(candidates.size()), 0, count,
                       [&](int a, int b) { return (centre(a) - centre(b)).norm(); });
    for (int& view : chosen) view = candidates[static_cast<std::size_t>(view)];
    return chosen;
}

}  // namespace lumi
