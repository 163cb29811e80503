#include "pipeline/evaluate/resampled_pictures.h"

#include "render/renderer/offscreen_renderer.h"

namespace lumi {

RenderOptions ResampledPictures::on_shared_plane(RenderOptions options) const {
    if (options.mode == RenderMode::kLightField) options.focal_plane = shared_plane;
    return options;
}

ResampledPictures resampled_pictures(const ResampledRival& rival, const Lumigraph& lumigraph,
                                     const Progress& progress) {
    OffscreenRenderer source(lumigraph);
    const LightFieldLayout layout = rival.layout(lumigraph);
    return {resampled(lumigraph, layout,
                      [&](const Eye& eye) {
                          progress.throw_if_interrupted();
                          return source.draw(eye, {.mode = RenderMode::kPerPixel});
                      }),
            layout.shared_plane};
}

}  // namespace lumi
