#include "render/reference/depth_of_others.h"

#include <algorithm>
#include <cmath>

#include "calib/work/parallel_for.h"
#include "render/reference/eye_depths.h"

namespace lumi {
namespace {

int samples_of(int pixels, double per_pixel) {
    return std::max(1, static_cast<int>(std::lround(pixels * per_pixel)));
}

}  // namespace

bool lacks_depth(const Lumigraph& lumigraph) {
    return lumigraph.has_depth() &&
           !std::all_of(lumigraph.views.begin(), lumigraph.views.end(),
                        [](const LumigraphView& view) { return view.has_depth(); });
}

Lumigraph with_depth_of_others(const Lumigraph& lumigraph) {
    Lumigraph whole = lumigraph;
    if (!lumigraph.has_depth()) return whole;
    const auto other = std::find_if(lumigraph.views.begin(), lumigraph.views.end(),
                                    [](const LumigraphView& view) { return view.has_depth(); });
    const double per_pixel =
        static_cast<double>(other->depth.inverse_depth.width()) / other->camera.width_px;
    parallel_for(static_cast<int>(whole.views.size()), 0, [&](int i) {
        LumigraphView& view = whole.views[static_cast<std::size_t>(i)];
        if (view.has_depth()) return;
        const Camera in_samples = resized(view.camera, samples_of(view.camera.width_px, per_pixel),
                                          samples_of(view.camera.height_px, per_pixel));
        view.depth =
            depth_map_at(lumigraph, {in_samples, view.cam_from_world}, kAgreeingDisparity_px);
        view.depth_mesh.reset();
    });
    return whole;
}

}  // namespace lumi
