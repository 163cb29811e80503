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
#include "render/gl/draw_queries.h"
#include "render/gl/framebuffer.h"
#include "render/gl/headless_context.h"
#include "render/renderer/lumigraph_renderer.h"

namespace lumi {
namespace {

constexpr int kWarmUpRounds = 2;
constexpr std::size_t kAskedFrames = 8;

/// Wall and CPU times of one drawing, frame by frame.
struct Times {
    std::vector<double> wall_ms;
    std::vector<double> cpu_ms;
};

FrameCost cost_of(const Times& times) {
    return {quantile_of(times.wall_ms, 0.5), quantile_of(times.wall_ms, 0.95),
            quantile_of(times.cpu_ms, 0.5), quantile_of(times.cpu_ms, 0.95)};
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

/// Over the pixels, mean over the frames.
std::optional<double> fragments_per_pixel(const std::vector<Eye>& frames, const Viewport& viewport,
                                          const std::function<void(const Eye&)>& draw) {
    double sum = 0;
    for (const Eye& eye : frames) {
        const auto count = fragment_count([&] { draw(eye); });
        if (!count) return std::nullopt;
        sum += static_cast<double>(*count);
    }
    return sum / static_cast<double>(frames.size()) / viewport.width_px / viewport.height_px;
}

/// Draws the frames in every way in turn: of each way the median by the card's clock.
std::vector<std::optional<double>> device_ms(
    const std::vector<Eye>& frames, const std::vector<std::function<void(const Eye&)>>& draws) {
    std::vector<std::vector<double>> times_ms(draws.size());
    for (const Eye& eye : frames)
        for (std::size_t i = 0; i < draws.size(); ++i)
            if (const auto time_ms = device_time_ms([&] { draws[i](eye); }))
                times_ms[i].push_back(*time_ms);
    std::vector<std::optional<double>> medians;
    for (std::vector<double>& of_draw : times_ms)
        medians.push_back(of_draw.empty() ? std::nullopt
                                          : std::optional(median_of(std::move(of_draw))));
    return medians;
}

}  // namespace

std::vector<Eye> frames_asked_about(const std::vector<Eye>& path) {
    const std::size_t frames = std::min(kAskedFrames, path.size());
    std::vector<Eye> asked;
    for (std::size_t i = 0; i < frames; ++i) asked.push_back(path[i * path.size() / frames]);
    return asked;
}

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
    std::vector<double> bytes(modes.size(), 0.0);
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
            const std::uint64_t uploaded = uploaded_bytes([&] {
                time_one([&] { statistics = renderer.draw(eye, modes[i], viewport); }, counted,
                         mode_times[i]);
            });
            if (!counted) continue;
            triangles[i] += static_cast<double>(statistics.triangles) / report.frames;
            bytes[i] += static_cast<double>(uploaded) / report.frames;
        }
        progress.advance();
    }

    report.base = cost_of(base_times);
    const std::vector<Eye> asked = frames_asked_about(path);
    std::vector<std::function<void(const Eye&)>> draws{[&](const Eye&) { blend.draw(viewport); }};
    for (const RenderOptions& mode : modes)
        draws.emplace_back([&](const Eye& eye) { renderer.draw(eye, mode, viewport); });
    framebuffer.bind();
    const std::vector<std::optional<double>> by_card_ms = device_ms(asked, draws);
    report.base_device_ms = by_card_ms.front();
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const FrameCost cost = cost_of(mode_times[i]);
        framebuffer.bind();
        report.modes.push_back({modes[i], cost, by_card_ms[i + 1], triangles[i],
                                fragments_per_pixel(asked, viewport, draws[i + 1]), bytes[i],
                                std::move(mode_times[i].cpu_ms),
                                cost.median_ms / report.base.median_ms,
                                cost.cpu_ms / report.base.cpu_ms});
    }
    return report;
}

}  // namespace lumi
