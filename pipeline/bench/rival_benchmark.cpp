#include "pipeline/bench/rival_benchmark.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "calib/work/median.h"
#include "calib/work/stopwatch.h"
#include "pipeline/bench/picture_change.h"
#include "pipeline/bench/rival_scenes.h"
#include "pipeline/evaluate/image_metrics.h"
#include "render/bench/frame_timing.h"
#include "render/bench/occlusion_share.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/rivals/rival_methods.h"

namespace lumi {
namespace {

constexpr int kGrossError = 51;      // A fifth of the range.
constexpr int kSilhouette_px = 2;    // Around which pixels may show either surface.
constexpr double kDepthStep = 0.03;  // Share of the inverse depth that makes a silhouette.
constexpr int kOftener = 4;          // Small differences are timed so many times as often.

using Draw = std::function<Frame(const Eye&)>;

bool is_by_a_silhouette(const FloatImage& z, int x, int y) {
    float nearest = 0;
    float farthest = 1e30F;
    for (int row = y - kSilhouette_px; row <= y + kSilhouette_px; ++row) {
        for (int column = x - kSilhouette_px; column <= x + kSilhouette_px; ++column) {
            if (!z.contains(column, row)) continue;
            const float q = z(column, row) > 0 ? 1 / z(column, row) : 0.0F;
            nearest = std::max(nearest, q);
            farthest = std::min(farthest, q);
        }
    }
    return static_cast<double>(nearest - farthest) > kDepthStep * static_cast<double>(nearest);
}

struct WrongLayerShares {
    double all = 0.0;
    double avoidable = 0.0;  ///< Where some photograph shows what is there.
};

WrongLayerShares wrong_layer_shares(const Frame& drawn, const TrueFrame& truth) {
    long wrong = 0;
    long avoidable = 0;
    for (int y = 0; y < truth.picture.height(); ++y) {
        for (int x = 0; x < truth.picture.width(); ++x) {
            const Rgb8& a = drawn.color(x, y);
            const Rgb8& b = truth.picture(x, y);
            const int error =
                std::max({std::abs(a.r - b.r), std::abs(a.g - b.g), std::abs(a.b - b.b)});
            if (error <= kGrossError || drawn.coverage(x, y) == 0 ||
                is_by_a_silhouette(truth.depth, x, y))
                continue;
            ++wrong;
            if (truth.shown(x, y) != 0) ++avoidable;
        }
    }
    const auto pixels = static_cast<double>(truth.picture.pixels().size());
    return {static_cast<double>(wrong) / pixels, static_cast<double>(avoidable) / pixels};
}

RivalFigures measured(const std::string& method, const std::string& settings, std::size_t pictures,
                      const RivalCapture& capture, const Draw& draw) {
    RivalFigures figures;
    figures.method = method;
    figures.settings = settings;
    figures.pictures = static_cast<int>(pictures);
    const auto count = static_cast<double>(capture.held_out.size());
    for (const TrueFrame& truth : capture.held_out) {
        const Frame drawn = draw(truth.eye);
        figures.psnr_db += psnr_db(drawn.color, truth.picture) / count;
        figures.psnr_covered_db +=
            psnr_db(drawn.color, truth.picture, drawn.coverage).value_or(0) / count;
        figures.coverage += covered_share(drawn.coverage) / count;
        const WrongLayerShares wrong = wrong_layer_shares(drawn, truth);
        figures.wrong_layer_share += wrong.all / count;
        figures.avoidable_wrong_layer_share += wrong.avoidable / count;
    }
    if (capture.path.size() < 2) return figures;
    ColorImage before = draw(capture.path.front().eye).color;
    double flicker = 0;
    for (std::size_t i = 1; i < capture.path.size(); ++i) {
        ColorImage now = draw(capture.path[i].eye).color;
        flicker += unlike_change(now, before, capture.path[i].picture, capture.path[i - 1].picture);
        before = std::move(now);
    }
    figures.flicker = flicker / static_cast<double>(capture.path.size() - 1);
    return figures;
}

/// Plain code, on one core.
RivalFigures measured_and_timed(const std::string& method, std::size_t pictures,
                                const RivalCapture& capture, const Draw& draw) {
    std::vector<double> cpu_ms;
    std::vector<double> wall_ms;
    RivalFigures figures = measured(method, "plain code", pictures, capture, [&](const Eye& eye) {
        const Stopwatch stopwatch;
        Frame frame = draw(eye);
        const Cost cost = stopwatch.elapsed();
        cpu_ms.push_back(1000 * cost.cpu_s);
        wall_ms.push_back(1000 * cost.wall_s);
        return frame;
    });
    figures.cpu_ms = median_of(std::move(cpu_ms));
    figures.wall_ms = median_of(std::move(wall_ms));
    return figures;
}

struct NamedOptions {
    std::string settings;
    RenderOptions options;
};

/// Errors give way until there are so many, which alone they would not ask for.
RenderOptions as_many_triangles(std::size_t count) {
    return {.mode = RenderMode::kAdaptive,
            .triangle_error_ratio = 0.02,
            .min_triangle_px = 0.5,
            .max_triangles = count};
}

/// With one sample a pixel, as all methods that they are compared with.
std::vector<NamedOptions> settings_of_free_form(const std::vector<std::size_t>& paper_triangles) {
    std::vector<NamedOptions> all{
        {"", {.mode = RenderMode::kLightField}},
        {"", {.mode = RenderMode::kHeigl}},
        {"", {.mode = RenderMode::kPerPixel, .smooth_silhouettes = false}},
        {"no occlusion correction",
         {.mode = RenderMode::kPerPixel, .correct_occlusion = false, .smooth_silhouettes = false}}};
    for (const std::size_t triangles : {std::size_t{500}, std::size_t{1000}, std::size_t{5000}})
        all.push_back({"<= " + std::to_string(triangles),
                       {.mode = RenderMode::kAdaptive, .max_triangles = triangles}});
    for (const std::size_t triangles : paper_triangles)
        all.push_back({"as the paper: " + std::to_string(triangles), as_many_triangles(triangles)});
    all.push_back(
        {"no occlusion correction", {.mode = RenderMode::kAdaptive, .correct_occlusion = false}});
    for (const double min_px : {24.0, 12.0, 6.0})
        all.push_back({"triangles >= " + std::to_string(static_cast<int>(min_px)) + " px",
                       {.mode = RenderMode::kPaper2001, .min_triangle_px = min_px}});
    return all;
}

std::vector<Eye> timed_path(const RivalCapture& capture, int frames) {
    std::vector<Eye> eyes;
    for (int i = 0; i < frames; ++i)
        eyes.push_back(capture.held_out[static_cast<std::size_t>(i) % capture.held_out.size()].eye);
    return eyes;
}

/// Measures one Lumigraph in some modes and appends the figures.
void append_modes(const std::string& prefix, const Lumigraph& lumigraph,
                  const std::vector<NamedOptions>& modes, const RivalCapture& capture, int frames,
                  Progress& progress, std::vector<RivalFigures>& rivals) {
    std::vector<RenderOptions> options;
    for (const NamedOptions& mode : modes) options.push_back(mode.options);
    const FrameTimingReport timing =
        time_frames(lumigraph, timed_path(capture, frames), options, progress);
    OffscreenRenderer renderer(lumigraph);
    for (std::size_t i = 0; i < modes.size(); ++i) {
        progress.throw_if_interrupted();
        RivalFigures figures =
            measured(prefix + name_of(options[i].mode), modes[i].settings, lumigraph.views.size(),
                     capture, [&](const Eye& eye) { return renderer.draw(eye, options[i]); });
        figures.triangles = timing.modes[i].triangles;
        figures.cpu_ms = timing.modes[i].cost.cpu_ms;
        figures.wall_ms = timing.modes[i].cost.median_ms;
        figures.cpu_ratio = timing.modes[i].cpu_ratio;
        rivals.push_back(std::move(figures));
    }
}

RivalScene measured_scene(const std::string& name, const RivalBenchmarkOptions& options,
                          Progress& progress) {
    const RivalCapture capture = rival_capture(name,
                                               {.size_px = options.size_px,
                                                .held_out = options.held_out,
                                                .path_frames = options.flicker_frames},
                                               progress);
    const Lumigraph& lumigraph = capture.lumigraph;
    RivalScene scene;
    scene.name = capture.name;
    scene.paper = capture.paper;
    scene.photographs = static_cast<int>(lumigraph.views.size());
    append_modes("", lumigraph, settings_of_free_form(capture.paper_triangles), capture,
                 options.frames, progress, scene.rivals);
    const std::vector<Eye> path = timed_path(capture, kOftener * options.frames);
    scene.per_pixel_occlusion_share = occlusion_share(
        lumigraph, path, {.mode = RenderMode::kPerPixel, .smooth_silhouettes = false}, progress);
    scene.adaptive_occlusion_share =
        occlusion_share(lumigraph, path, {.mode = RenderMode::kAdaptive}, progress);

    OffscreenRenderer source(lumigraph);
    const Draw draw_source = [&](const Eye& eye) { return source.draw(eye, {}); };
    const std::vector<NamedOptions> resampled_modes{{"", {.mode = RenderMode::kLightField}},
                                                    {"<= 5000", {.mode = RenderMode::kAdaptive}}};
    for (const ResampledRival& rival : resampled_rivals()) {
        if (!rival.reason_against(lumigraph).empty()) continue;
        const Stopwatch stopwatch;
        const Lumigraph pictures = resampled(lumigraph, rival.layout(lumigraph), draw_source);
        // Two-plane comes first.
        if (scene.resampling_cpu_s == 0) scene.resampling_cpu_s = stopwatch.elapsed().cpu_s;
        append_modes(rival.name + ' ', pictures, resampled_modes, capture, options.frames, progress,
                     scene.rivals);
    }
    for (const PlainRival& rival : plain_rivals()) {
        progress.throw_if_interrupted();
        scene.rivals.push_back(
            measured_and_timed(rival.name, lumigraph.views.size(), capture,
                               [&](const Eye& eye) { return rival.draw(lumigraph, eye); }));
    }
    return scene;
}

}  // namespace

std::vector<RivalScene> benchmark_rivals(const RivalBenchmarkOptions& options,
                                         const std::vector<std::string>& scenes,
                                         Progress& progress) {
    std::vector<RivalScene> measured;
    for (const std::string& name : scenes)
        measured.push_back(measured_scene(name, options, progress));
    return measured;
}

}  // namespace lumi
