#include "render/viewer/window_beginning.h"

#include "render/paths/photograph_eye.h"
#include "render/viewer/window_size.h"

namespace lumi {

ViewerState state_at_beginning(const OpenedPackage& opened, const WindowOptions& options) {
    ViewerState state = first_state(opened.lumigraph, options.render);
    state.render.fade_beyond_capture = opened.fade_beyond_capture;
    const std::string& name = options.view_name;
    if (!name.empty())
        go_to_photograph(index_of_view(opened.lumigraph, name), opened.lumigraph, state);
    state.frames_per_second = options.frames_per_second;
    state.package = options.package;
    state.exposures = options.exposures;
    state.planned = opened.planned;
    go_to_planned(options.planned_index, opened.lumigraph, state);
    if (!options.eyes.empty()) go_to_eye(options.eyes.front().eye, state);
    return state;
}

Eigen::Vector2i first_size_px(const WindowOptions& options, const Camera& camera) {
    if (options.width_px > 0 && options.height_px > 0) return {options.width_px, options.height_px};
    if (!options.screenshot_path.empty()) return {camera.width_px, camera.height_px};
    return window_size_px(camera);
}

}  // namespace lumi
