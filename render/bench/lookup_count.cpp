#include "render/bench/lookup_count.h"

#include <functional>

#include "render/bench/frame_timing.h"
#include "render/bench/three_texture_blend.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/gl/lookup_meter.h"
#include "render/renderer/lumigraph_renderer.h"

namespace lumi {

LookupCounts count_lookups(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                           const std::vector<RenderOptions>& modes, const Progress& progress) {
    const HeadlessContext context;
    const LookupMeter meter;
    LumigraphRenderer renderer(lumigraph);
    const ThreeTextureBlend blend(lumigraph);
    const Camera& camera = path.front().camera;
    const Viewport viewport{0, 0, camera.width_px, camera.height_px};
    Framebuffer framebuffer;
    framebuffer.attach_color(viewport.width_px, viewport.height_px);
    framebuffer.bind();
    const std::vector<Eye> frames = frames_asked_about(path);
    const auto per_pixel = [&](const std::function<void(const Eye&)>& draw) {
        std::optional<double> sum = 0.0;
        for (const Eye& eye : frames) {
            progress.throw_if_interrupted();
            const auto count = meter.lookups([&] { draw(eye); });
            if (!count) return std::optional<double>();
            *sum += static_cast<double>(*count);
        }
        *sum /= static_cast<double>(frames.size()) * viewport.width_px * viewport.height_px;
        return sum;
    };
    LookupCounts counts;
    counts.base_per_pixel = per_pixel([&](const Eye&) { blend.draw(viewport); });
    for (const RenderOptions& mode : modes)
        counts.modes_per_pixel.push_back(
            per_pixel([&](const Eye& eye) { renderer.draw(eye, mode, viewport); }));
    return counts;
}

}  // namespace lumi
