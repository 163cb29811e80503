#include "meshing/depth_scene/views_around.h"

#include <set>

namespace lumi {

std::vector<int> views_around(const DepthScene& scene, int view_index) {
    const auto neighbours_of = [&](int view) -> const std::vector<int>& {
        return scene.views[static_cast<std::size_t>(view)].neighbours;
    };
    std::vector<int> around = neighbours_of(view_index);
    std::set<int> listed(around.begin(), around.end());
    listed.insert(view_index);
    for (const int j : neighbours_of(view_index)) {
        for (const int next : neighbours_of(j)) {
            if (listed.insert(next).second) around.push_back(next);
        }
    }
    return around;
}

}  // namespace lumi
