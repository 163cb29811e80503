#include "render/bench/frame_timing.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>
#include <functional>
#include <utility>

#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "calib/work/stopwatch.h"
#include "render/bench/three_texture_blend.h"
#include "render/gl/capabilities.h"
#include "render/gl/fragment_count.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/renderer/lumigraph_renderer.h"

namespace lumi {
namespace {

constexpr int kWarmUpRounds = 2;
/// Frames whose fragments are counted, as counting is not to be timed.
constexpr std::size_t kCountedFrames = 8;

/// Wall and CPU times of one drawing, frame by frame.
struct Times {
    std::vector<double> wall_ms;
    std::vector<double> cpu_ms;
};

FrameCost cost_of(const Times& times) {
    return {quantile_of(times.wall_ms, 0.5), quantile_of(times.wall_ms, 0.95),
            quantile_of(times.cpu_ms, 0.5)};
}

void time_one(const std::function<void()>& draw, bool counted, Times& times) {
    glFinish();
    const Stopwatch stopwatch;
    draw();
    glFinish();
    const Cost cost = stopwatch.elapsed();
    if (!counted) return;
    times.wall_ms.push_back(1000 * cost.wall_s);
    times.cpu_ms.push_back(1000 * cost.cpu_s);
}

/// Over the pixels, mean over frames spread over the path.
std::optional<double> fragments_per_pixel(LumigraphRenderer& renderer, const std::vector<Eye>& path,
                                          const RenderOptions& mode, const Viewport& viewport) {
    const std::size_t frames = std::min(kCountedFrames, path.size());
    double sum = 0;
    for (std::size_t i = 0; i < frames; ++i) {
        const auto count =
            fragment_count([&] { renderer.draw(path[i * path.size() / frames], mode, viewport); });
        if (!count) return std::nullopt;
        sum += static_cast<double>(*count);
    }
    return sum / static_cast<double>(frames) / viewport.width_px / viewport.height_px;
}

}  // namespace

FrameTimingReport time_frames(const Lumigraph& lumigraph, const std::vector<Eye>& path,
                              const std::vector<RenderOptions>& modes, Progress& progress) {
    assert(!path.empty());
    const HeadlessContext context;
    FrameTimingReport report;
    report.gl_description = query_capabilities().description;
    report.width_px = path.front().camera.width_px;
    report.height_px = path.front().camera.height_px;
    report.frames = static_cast<int>(path.size());
    report.threads = resolve_threads(0);

    LumigraphRenderer renderer(lumigraph);
    report.texture_bytes = renderer.texture_bytes();
    const ThreeTextureBlend blend(lumigraph);
    Framebuffer framebuffer;
    framebuffer.attach_color(report.width_px, report.height_px);
    const Viewport viewport{0, 0, report.width_px, report.height_px};

    Times base_times;
    std::vector<Times> mode_times(modes.size());
    std::vector<double> triangles(modes.size(), 0.0);
    const int rounds = kWarmUpRounds + report.frames;
    progress.begin("drawing", static_cast<std::size_t>(rounds));
    for (int round = 0; round < rounds; ++round) {
        progress.throw_if_interrupted();
        const bool counted = round >= kWarmUpRounds;
        const Eye& eye = path[static_cast<std::size_t>(counted ? round - kWarmUpRounds : 0)];
        framebuffer.bind();
        time_one([&] { blend.draw(viewport); }, counted, base_times);
        for (std::size_t i = 0; i < modes.size(); ++i) {
            framebuffer.bind();
            DrawStatistics statistics;
            time_one([&] { statistics = renderer.draw(eye, modes[i], viewport); }, counted,
                     mode_times[i]);
            if (counted) triangles[i] += static_cast<double>(statistics.triangles) / report.frames;
        }
        progress.advance();
    }

    report.base = cost_of(base_times);
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const FrameCost cost = cost_of(mode_times[i]);
        framebuffer.bind();
        report.modes.push_back(
            {modes[i], cost, triangles[i], fragments_per_pixel(renderer, path, modes[i], viewport),
             std::move(mode_times[i].cpu_ms), cost.median_ms / report.base.median_ms,
             cost.cpu_ms / report.base.cpu_ms});
    }
    return report;
}

}  // namespace lumi
