#include "meshing/depth/views_far_apart.h"

#include <algorithm>
#include <limits>

namespace lumi {

std::vector<int> views_far_apart(const DepthScene& scene, std::vector<int> candidates,
                                 std::size_t count) {
    const auto centre = [&](int i) {
        return centre_in_world(scene.views[static_cast<std::size_t>(i)].cam_from_world);
    };
    std::vector<int> chosen;
    while (!candidates.empty() && chosen.size() < count) {
        const auto distance = [&](int i) {
            double nearest = chosen.empty() ? 0.0 : std::numeric_limits<double>::infinity();
            for (const int j : chosen) nearest = std::min(nearest, (centre(i) - centre(j)).norm());
            return nearest;
        };
        const auto next = std::max_element(candidates.begin(), candidates.end(),
                                           [&](int a, int b) { return distance(a) < distance(b); });
        chosen.push_back(*next);
        candidates.erase(next);
    }
    return chosen;
}

}  // namespace lumi
