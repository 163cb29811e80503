#include "pipeline/stages/chosen_views.h"

#include <algorithm>
#include <string>

#include "calib/work/parallel_for.h"
#include "meshing/cameras/scene_centre.h"
#include "meshing/selection/thumbnail_prediction.h"
#include "meshing/selection/view_worth.h"
#include "pipeline/stages/used_views.h"
#include "render/lumigraph/even_exposure.h"

namespace lumi {

Lumigraph lumigraph_of_views(const Lumigraph& lumigraph, const Capture& capture,
                             const std::vector<int>& views, const CameraMeshOptions& mesh_options) {
    Lumigraph chosen = without_its_views(lumigraph);
    std::vector<int> new_index(lumigraph.views.size(), -1);
    for (const int view : views) {
        new_index[static_cast<std::size_t>(view)] = static_cast<int>(chosen.views.size());
        chosen.views.push_back(lumigraph.views[static_cast<std::size_t>(view)]);
    }
    chosen.mesh = build_camera_mesh(capture, views, mesh_options).mesh;
    renumber_views(chosen.mesh, new_index);
    return chosen;
}

Capture capture_of(const Lumigraph& lumigraph, const PosedPhotographs& photographs) {
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    std::sort(names.begin(), names.end());
    return only_views(photographs, names).capture;
}

std::vector<PicturedView> pictured_views(const Lumigraph& lumigraph) {
    std::vector<PicturedView> pictured;
    for (const LumigraphView& view : lumigraph.views) {
        pictured.push_back({&view.photograph, view.camera, view.cam_from_world, &view.depth});
    }
    return pictured;
}

std::vector<int> views_by_worth(const Lumigraph& lumigraph, const Capture& capture,
                                const std::vector<int>& views, int threads,
                                const Progress& progress) {
    std::vector<PicturedView> pictured;
    std::vector<ColorImage> thumbnails(views.size());
    parallel_for(static_cast<int>(views.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(views[index])];
        thumbnails[index] =
            thumbnail_of(evened_photograph(view, lumigraph.light_falloff), view.camera);
    });
    for (std::size_t i = 0; i < views.size(); ++i) {
        const LumigraphView& view = lumigraph.views[static_cast<std::size_t>(views[i])];
        pictured.push_back({&thumbnails[i], view.camera, view.cam_from_world, &view.depth});
    }
    const std::vector<OpticalAxis> axes = optical_axes(capture, views);
    std::vector<int> order;
    for (const int i : views_by_worth(pictured, axes, estimate_scene_centre(axes), progress)) {
        order.push_back(views[static_cast<std::size_t>(i)]);
    }
    return order;
}

std::vector<int> most_worthy_views(const std::vector<int>& by_worth, int count) {
    std::vector<int> views(
        by_worth.begin(),
        by_worth.begin() + std::clamp(count, 0, static_cast<int>(by_worth.size())));
    std::sort(views.begin(), views.end());
    return views;
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
