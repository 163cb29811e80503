#include "pipeline/evaluate/resampled_pictures.h"

#include "render/renderer/offscreen_renderer.h"

namespace lumi {

Lumigraph resampled_pictures(const ResampledRival& rival, const Lumigraph& lumigraph,
                             const Progress& progress) {
    OffscreenRenderer source(lumigraph);
    return resampled(lumigraph, rival.layout(lumigraph), [&](const Eye& eye) {
        progress.throw_if_interrupted();
        return source.draw(eye, {.mode = RenderMode::kPerPixel});
    });
}

}  // namespace lumi
