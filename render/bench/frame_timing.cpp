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

/// What is drawn in turn, and where.
struct Stage {
    Stage(const Lumigraph& lumigraph, const Camera& camera)
        : renderer(lumigraph), blend(lumigraph), viewport{0, 0, camera.width_px, camera.height_px} {
        framebuffer.attach_color(camera.width_px, camera.height_px);
    }

    LumigraphRenderer renderer;
    ThreeTextureBlend blend;
    Framebuffer framebuffer;
    Viewport viewport;
};

/// Of one mode, frame by frame.
struct ModeTally {
    Times times;
    std::vector<double> triangles;
    std::vector<double> uploaded_bytes;
};

/// One frame by the blend and in every mode.
void draw_round(Stage& stage, const Eye& eye, const std::vector<RenderOptions>& modes, bool counted,
                Times& base_times, std::vector<ModeTally>& tallies) {
    stage.framebuffer.bind();
    time_one([&] { stage.blend.draw(stage.viewport); }, counted, base_times);
    for (std::size_t i = 0; i < modes.size(); ++i) {
        stage.framebuffer.bind();
        stage.renderer.forget_frame();
        DrawStatistics statistics;
        const auto draw = [&] { statistics = stage.renderer.draw(eye, modes[i], stage.viewport); };
        const std::uint64_t uploaded =
            uploaded_bytes([&] { time_one(draw, counted, tallies[i].times); });
        if (!counted) continue;
        tallies[i].triangles.push_back(static_cast<double>(statistics.triangles));
        tallies[i].uploaded_bytes.push_back(static_cast<double>(uploaded));
    }
}

double mean_of(const std::vector<double>& numbers) {
    double sum = 0;
    for (const double number : numbers) sum += number / static_cast<double>(numbers.size());
    return sum;
}

/// What the tallies come to, and what is asked of OpenGL besides.
void report_modes(Stage& stage, const std::vector<Eye>& path,
                  const std::vector<RenderOptions>& modes, std::vector<ModeTally> tallies,
                  FrameTimingReport& report) {
    const std::vector<Eye> asked = frames_asked_about(path);
    std::vector<std::function<void(const Eye&)>> draws{
        [&](const Eye&) { stage.blend.draw(stage.viewport); }};
    for (const RenderOptions& mode : modes)
        draws.emplace_back([&](const Eye& eye) { stage.renderer.draw(eye, mode, stage.viewport); });
    stage.framebuffer.bind();
    const std::vector<std::optional<double>> by_card_ms = device_ms(asked, draws);
    report.base_device_ms = by_card_ms.front();
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const FrameCost cost = cost_of(tallies[i].times);
        stage.framebuffer.bind();
        report.modes.push_back(
            {modes[i], cost, by_card_ms[i + 1], mean_of(tallies[i].triangles),
             fragments_per_pixel(asked, stage.viewport, draws[i + 1]),
             mean_of(tallies[i].uploaded_bytes), std::move(tallies[i].times.cpu_ms),
             cost.median_ms / report.base.median_ms, cost.cpu_ms / report.base.cpu_ms});
    }
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
    Stage stage(lumigraph, path.front().camera);
    FrameTimingReport report;
    report.gl_description = query_capabilities().description;
    report.width_px = stage.viewport.width_px;
    report.height_px = stage.viewport.height_px;
    report.frames = static_cast<int>(path.size());
    report.threads = resolve_threads(0);
    report.texture_bytes = stage.renderer.texture_bytes();

    Times base_times;
    std::vector<ModeTally> tallies(modes.size());
    const int rounds = kWarmUpRounds + report.frames;
    progress.begin("drawing", static_cast<std::size_t>(rounds));
    for (int round = 0; round < rounds; ++round) {
        progress.throw_if_interrupted();
        const bool counted = round >= kWarmUpRounds;
        const Eye& eye = path[static_cast<std::size_t>(counted ? round - kWarmUpRounds : 0)];
        draw_round(stage, eye, modes, counted, base_times, tallies);
        progress.advance();
    }
    report.base = cost_of(base_times);
    report_modes(stage, path, modes, std::move(tallies), report);
    return report;
}

}  // namespace lumi
