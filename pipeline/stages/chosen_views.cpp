#include "pipeline/stages/chosen_views.h"

#include <numeric>

#include "meshing/cameras/scene_centre.h"
#include "meshing/selection/view_selection.h"

namespace lumi {

Lumigraph lumigraph_of_views(const Lumigraph& lumigraph, const Capture& capture,
                             const std::vector<int>& views, const CameraMeshOptions& mesh_options) {
    Lumigraph chosen;
    chosen.name = lumigraph.name;
    chosen.near_depth = lumigraph.near_depth;
    chosen.far_depth = lumigraph.far_depth;
    std::vector<int> new_index(lumigraph.views.size(), -1);
    for (const int view : views) {
        new_index[static_cast<std::size_t>(view)] = static_cast<int>(chosen.views.size());
        chosen.views.push_back(lumigraph.views[static_cast<std::size_t>(view)]);
    }
    chosen.mesh = build_camera_mesh(capture, views, mesh_options).mesh;
    renumber_views(chosen.mesh, new_index);
    return chosen;
}

std::vector<int> representative_views_of(const Capture& capture, int count) {
    std::vector<int> all(capture.views.size());
    std::iota(all.begin(), all.end(), 0);
    if (count >= static_cast<int>(all.size())) return all;
    const std::vector<OpticalAxis> axes = optical_axes(capture, all);
    return representative_views(axes, estimate_scene_centre(axes), count);
}

double texture_mib(const Lumigraph& lumigraph, const std::vector<int>& views) {
    double bytes = 0;
    for (const int index : views) {
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(index)];
        bytes += 4.0 * static_cast<double>(view.photograph.pixels().size());
        bytes += 4.0 * static_cast<double>(view.depth.inverse_depth.pixels().size());
    }
    return bytes / (1 << 20);
}

}  // namespace lumi
