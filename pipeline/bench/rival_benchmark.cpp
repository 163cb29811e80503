#include "pipeline/bench/rival_benchmark.h"

#include <algorithm>
#include <iterator>

#include "calib/work/median.h"
#include "calib/work/stopwatch.h"
#include "pipeline/bench/rival_measurement.h"
#include "pipeline/evaluate/resampled_pictures.h"
#include "render/bench/frame_timing.h"
#include "render/bench/occlusion_share.h"
#include "render/renderer/offscreen_renderer.h"
#include "render/rivals/rival_methods.h"

namespace lumi {
namespace {

constexpr int kOftener = 4;  // Small differences are timed so many times as often.

/// Only frames of held-out places are timed, which are drawn first: modes are timed by no others.
RivalFigures measured_and_timed(const PlainRival& rival, const RivalCapture& capture,
                                RivalMeasurement& measurement, Progress& progress) {
    const Lumigraph& lumigraph = capture.lumigraph;
    std::vector<double> depth_cpu_ms;
    std::vector<double> cpu_ms;
    std::vector<double> wall_ms;
    const DrawFrame draw = [&](const Eye& eye) {
        progress.throw_if_interrupted();
        const Stopwatch stopwatch;
        const EyeDepths known = depths_for(rival, lumigraph, eye);
        const double of_depth_ms = 1000 * stopwatch.elapsed().cpu_s;
        Frame frame = rival.draw(lumigraph, eye, known);
        const Cost cost = stopwatch.elapsed();
        if (cpu_ms.size() == capture.held_out.size()) return frame;
        depth_cpu_ms.push_back(of_depth_ms);
        cpu_ms.push_back(1000 * cost.cpu_s);
        wall_ms.push_back(1000 * cost.wall_s);
        return frame;
    };
    RivalFigures figures =
        measurement.measured({rival.name, "plain code", static_cast<int>(lumigraph.views.size()),
                              rival.draws_from_depth},
                             draw);
    figures.cpu_ms = median_of(std::move(cpu_ms));
    figures.wall_ms = median_of(std::move(wall_ms));
    if (rival.draws_on_eye_depths) figures.depth_cpu_ms = median_of(std::move(depth_cpu_ms));
    return figures;
}

struct NamedOptions {
    std::string settings;
    RenderOptions options;
};

/// What modes draw: the photographs themselves, or what they were resampled to.
struct DrawnLumigraph {
    std::string method;  ///< Before the name of the mode; empty: the photographs.
    const Lumigraph& lumigraph;

    [[nodiscard]] bool is_resampled() const { return !method.empty(); }
};

/// Errors give way until there are so many, which alone they would not ask for. Smaller ones, and
/// shorter edges, come to the same numbers by more thin triangles, which take longer and err more.
RenderOptions as_many_triangles(std::size_t count) {
    return {.mode = RenderMode::kAdaptive,
            .triangle_error_ratio = 0.1,
            .min_triangle_px = 2.0,
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
    all.push_back({"triangles >= 6 px, depths within 0.5 %",
                   {.mode = RenderMode::kPaper2001, .depth_threshold_share = 0.005}});
    return all;
}

std::vector<Eye> timed_path(const RivalCapture& capture, int frames) {
    std::vector<Eye> eyes;
    for (int i = 0; i < frames; ++i)
        eyes.push_back(capture.held_out[static_cast<std::size_t>(i) % capture.held_out.size()].eye);
    return eyes;
}

/// Measures one Lumigraph in some modes.
std::vector<RivalFigures> measured_modes(const DrawnLumigraph& drawn,
                                         const std::vector<NamedOptions>& modes,
                                         const std::vector<Eye>& path,
                                         RivalMeasurement& measurement, Progress& progress) {
    const Lumigraph& lumigraph = drawn.lumigraph;
    const std::string prefix = drawn.is_resampled() ? drawn.method + ' ' : "";
    std::vector<RenderOptions> options;
    for (const NamedOptions& mode : modes) options.push_back(mode.options);
    const FrameTimingReport timing = time_frames(lumigraph, path, options, progress);
    OffscreenRenderer renderer(lumigraph);
    std::vector<RivalFigures> rivals;
    for (std::size_t i = 0; i < modes.size(); ++i) {
        progress.throw_if_interrupted();
        RivalFigures figures =
            measurement.measured({prefix + name_of(options[i].mode), modes[i].settings,
                                  static_cast<int>(lumigraph.views.size()),
                                  !drawn.is_resampled() && covers_by_depth(options[i].mode)},
                                 [&](const Eye& eye) { return renderer.draw(eye, options[i]); });
        figures.triangles = timing.modes[i].triangles;
        figures.cpu_ms = timing.modes[i].cost.cpu_ms;
        figures.wall_ms = timing.modes[i].cost.median_ms;
        figures.cpu_ratio = timing.modes[i].cpu_ratio;
        rivals.push_back(std::move(figures));
    }
    return rivals;
}

/// Of all pictures that it asks for, in the modes that draw without depth and with it.
std::vector<RivalFigures> measured_resampled(const ResampledRival& rival,
                                             const Lumigraph& lumigraph,
                                             const std::vector<Eye>& path,
                                             RivalMeasurement& measurement, Progress& progress) {
    const Stopwatch stopwatch;
    const ResampledPictures pictures = resampled_pictures(rival, lumigraph, progress);
    const double resampling_cpu_s = stopwatch.elapsed().cpu_s;
    std::vector<RivalFigures> rivals =
        measured_modes({rival.name, pictures.lumigraph},
                       {{"", pictures.on_shared_plane({.mode = RenderMode::kLightField})},
                        {"<= 5000", {.mode = RenderMode::kAdaptive}}},
                       path, measurement, progress);
    for (RivalFigures& figures : rivals) figures.resampling_cpu_s = resampling_cpu_s;
    return rivals;
}

RivalScene measured_scene(const std::string& name, const RivalBenchmarkOptions& options,
                          const RivalPictureSink& keep, Progress& progress) {
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
    RivalMeasurement measurement(capture, keep);
    const auto append = [&](std::vector<RivalFigures> figures) {
        std::move(figures.begin(), figures.end(), std::back_inserter(scene.rivals));
    };
    const std::vector<Eye> timed = timed_path(capture, options.frames);
    append(measured_modes({"", lumigraph}, settings_of_free_form(capture.paper_triangles), timed,
                          measurement, progress));
    const std::vector<Eye> path = timed_path(capture, kOftener * options.frames);
    scene.per_pixel_occlusion_share = occlusion_share(
        lumigraph, path, {.mode = RenderMode::kPerPixel, .smooth_silhouettes = false}, progress);
    scene.adaptive_occlusion_share =
        occlusion_share(lumigraph, path, {.mode = RenderMode::kAdaptive}, progress);

    for (const ResampledRival& rival : resampled_rivals())
        if (rival.reason_against(lumigraph).empty())
            append(measured_resampled(rival, lumigraph, timed, measurement, progress));
    for (const PlainRival& rival : plain_rivals())
        append({measured_and_timed(rival, capture, measurement, progress)});
    measurement.measure_common_pixels(scene.rivals);
    scene.common_share = measurement.common_share();
    scene.off_cameras_common_share = measurement.off_cameras_common_share();
    return scene;
}

}  // namespace

std::vector<RivalScene> benchmark_rivals(const RivalBenchmarkOptions& options,
                                         const std::vector<std::string>& scenes,
                                         const RivalPictureSink& keep, Progress& progress) {
    std::vector<RivalScene> measured;
    for (const std::string& name : scenes)
        measured.push_back(measured_scene(name, options, keep, progress));
    return measured;
}

}  // namespace lumi
