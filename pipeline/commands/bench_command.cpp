#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/process_memory.h"
#include "pipeline/bench/frame_rate_sweep.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/eye_path.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/evaluate/held_out_beside.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/optional_json.h"
#include "render/bench/frame_timing.h"
#include "render/bench/lookup_count.h"
#include "render/bench/occlusion_share.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

struct BenchRequest {
    std::filesystem::path package;
    std::string path = kViewsPath;
    std::string size = "1280x720";
    int frames = 60;
    std::vector<std::string> modes;  ///< Empty: all of them.
    bool occlusion_share = false;
    std::vector<double> frames_per_second;  ///< Asked for; empty: none.
};

/// Of each mode, if it is asked for and there is any.
using OcclusionShares = std::vector<std::optional<double>>;

std::vector<RenderOptions> options_of(const std::vector<std::string>& mode_names) {
    std::vector<RenderOptions> options;
    for (const std::string& name : mode_names) options.push_back({.mode = render_mode_from(name)});
    if (!options.empty()) return options;
    for (const RenderMode mode : all_render_modes()) options.push_back({.mode = mode});
    return options;
}

Json report_json(const FrameTimingReport& report, const LookupCounts& lookups,
                 const OcclusionShares& shares) {
    Json modes = Json::object();
    for (std::size_t i = 0; i < report.modes.size(); ++i) {
        const ModeCost& mode = report.modes[i];
        modes[name_of(mode.options.mode)] = {
            {"ratio", mode.ratio},
            {"cpu_ratio", mode.cpu_ratio},
            {"ms", mode.cost.median_ms},
            {"p95_ms", mode.cost.p95_ms},
            {"cpu_ms", mode.cost.cpu_ms},
            {"p95_cpu_ms", mode.cost.p95_cpu_ms},
            {"device_ms", optional_json(mode.device_ms)},
            {"triangles", mode.triangles},
            {"fragments_per_pixel", optional_json(mode.fragments_per_pixel)},
            {"fetches_per_pixel", optional_json(lookups.modes_per_pixel[i])},
            {"uploaded_bytes", mode.uploaded_bytes},
            {"occlusion_share", optional_json(shares[i])}};
    }
    return Json{{"base_ms", report.base.median_ms},
                {"base_cpu_ms", report.base.cpu_ms},
                {"base_fetches_per_pixel", optional_json(lookups.base_per_pixel)},
                {"base_device_ms", optional_json(report.base_device_ms)},
                {"size", {report.width_px, report.height_px}},
                {"frames", report.frames},
                {"threads", report.threads},
                {"texture_bytes", report.texture_bytes},
                {"gl_renderer", report.gl_description},
                {"modes", std::move(modes)}};
}

std::string row_text(const std::string& name, const FrameCost& cost, double cpu_ratio,
                     double ratio) {
    return padded_right(name, 24) + padded_left(number_text(cost.cpu_ms, 2), 8) +
           padded_left(number_text(cost.p95_cpu_ms, 2), 9) +
           padded_left(number_text(cost.median_ms, 2), 9) +
           padded_left(number_text(cost.p95_ms, 2), 9) + padded_left(number_text(cpu_ratio, 2), 9) +
           padded_left(number_text(ratio, 2), 9);
}

/// A line of what frames take by the card's clock.
std::string device_row_text(const std::string& name, double device_ms, double base_device_ms) {
    return padded_right(name, 24) + padded_left(number_text(device_ms, 3), 8) +
           padded_left(number_text(device_ms / base_device_ms, 2), 9) + "\n";
}

/// Nothing where OpenGL works on the CPU.
std::string device_text(const FrameTimingReport& report) {
    if (!report.base_device_ms) return {};
    std::string text =
        padded_right("by the card's clock", 24) + padded_left("ms", 8) + padded_left("blends", 9) +
        "\n" +
        device_row_text("blend of three textures", *report.base_device_ms, *report.base_device_ms);
    for (const ModeCost& mode : report.modes)
        if (mode.device_ms)
            text += device_row_text(name_of(mode.options.mode), *mode.device_ms,
                                    *report.base_device_ms);
    return text;
}

std::string report_text(const FrameTimingReport& report, const LookupCounts& lookups,
                        const OcclusionShares& shares) {
    const auto per_pixel = [](const std::optional<double>& count) {
        return padded_left(count ? number_text(*count, 2) : "-", 11);
    };
    constexpr double kBytesPerKibibyte = 1024.0;
    constexpr double kBytesPerMebibyte = 1024.0 * 1024.0;
    std::string text =
        counted(report.frames, "frame") + " of " + std::to_string(report.width_px) + "x" +
        std::to_string(report.height_px) + " on " + report.gl_description + ", " +
        counted(report.threads, "thread") + ", " +
        number_text(static_cast<double>(report.texture_bytes) / kBytesPerMebibyte, 0) +
        " MiB of textures\n" + padded_right("medians", 24) + padded_left("CPU ms", 8) +
        padded_left("95 %", 9) + padded_left("wall ms", 9) + padded_left("95 %", 9) +
        padded_left("blends", 9) + padded_left("(wall)", 9) + padded_left("triangles", 11) +
        padded_left("fragments", 11) + padded_left("fetches", 11) + padded_left("KiB", 9) + "\n" +
        row_text("blend of three textures", report.base, 1, 1) + padded_left("-", 11) +
        padded_left("-", 11) + per_pixel(lookups.base_per_pixel) + padded_left("-", 9) + "\n";
    for (std::size_t i = 0; i < report.modes.size(); ++i) {
        const ModeCost& mode = report.modes[i];
        text += row_text(name_of(mode.options.mode), mode.cost, mode.cpu_ratio, mode.ratio) +
                padded_left(number_text(mode.triangles, 0), 11) +
                per_pixel(mode.fragments_per_pixel) + per_pixel(lookups.modes_per_pixel[i]) +
                padded_left(number_text(mode.uploaded_bytes / kBytesPerKibibyte, 0), 9) + "\n";
    }
    text +=
        "blends: times the blend of three textures, by CPU time and by wall time;\n"
        "fragments, fetches: for a pixel of the picture, in all passes; fetches are texture "
        "lookups, counted by the shaders;\n"
        "KiB: of vertices, indices and texels that a frame hands to OpenGL\n";
    text += device_text(report);
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (shares[i])
            text += "occlusion correction takes " + number_text(100 * *shares[i], 1) + " % of " +
                    name_of(report.modes[i].options.mode) + " (the paper: 7 to 10 %)\n";
    return text;
}

Json sweep_json(const std::vector<FrameRateFigures>& sweep, std::size_t photographs) {
    Json rows = Json::array();
    for (const FrameRateFigures& figures : sweep)
        rows.push_back({{"asked_fps", figures.asked > 0 ? Json(figures.asked) : Json()},
                        {"reached_fps", figures.reached},
                        {"share_in_time", figures.share_in_time},
                        {"triangles", figures.triangles},
                        {"psnr_db", figures.psnr_db}});
    return Json{{"held_out", photographs}, {"adaptive", std::move(rows)}};
}

std::string sweep_text(const std::vector<FrameRateFigures>& sweep, std::size_t photographs) {
    std::string text = "adaptive at whole size, from one of " + std::to_string(photographs) +
                       " held-out photographs to the next\n" +
                       padded_right("frames a second asked", 24) + padded_left("reached", 9) +
                       padded_left("in time %", 11) + padded_left("triangles", 11) +
                       padded_left("dB", 9) + "\n";
    for (const FrameRateFigures& figures : sweep)
        text += padded_right(figures.asked > 0 ? number_text(figures.asked, 1) : "any", 24) +
                padded_left(number_text(figures.reached, 1), 9) +
                padded_left(number_text(100 * figures.share_in_time, 0), 11) +
                padded_left(number_text(figures.triangles, 0), 11) +
                padded_left(number_text(figures.psnr_db, 2), 9) + "\n";
    return text;
}

/// What a time budget buys and costs.
void run_frame_rate_sweep(const BenchRequest& request, const CommandContext& context) {
    const std::vector<HeldOutView> held_out = held_out_views_beside(request.package, 0);
    if (held_out.size() < 2)
        throw Error(ErrorKind::kUsage, "E-BENCH-HOLDOUT",
                    request.package.string() + ": beside it lie " +
                        std::to_string(held_out.size()) +
                        " held-out photographs, and two are needed to go from one to the next",
                    "set hold_out_every = 8 under [evaluate] in the configuration, build again, "
                    "and name the package in its workspace");
    const Lumigraph lumigraph = read_package(request.package);
    keep_free_memory();
    const std::vector<FrameRateFigures> sweep =
        sweep_frame_rates(lumigraph, held_out, request.frames_per_second, *context.progress);
    if (context.json) {
        context.print_result(sweep_json(sweep, held_out.size()));
    } else {
        context.print_result(sweep_text(sweep, held_out.size()));
    }
}

void run_bench(const BenchRequest& request, const CommandContext& context) {
    const std::vector<RenderOptions> modes = options_of(request.modes);
    const Lumigraph lumigraph = read_package(request.package);
    keep_free_memory();
    const std::vector<Eye> path = eye_path(request.path, request.frames, request.size, lumigraph);
    const FrameTimingReport report = time_frames(lumigraph, path, modes, *context.progress);
    const LookupCounts lookups = count_lookups(lumigraph, path, modes, *context.progress);
    OcclusionShares shares(modes.size());
    for (std::size_t i = 0; request.occlusion_share && i < modes.size(); ++i)
        if (corrects_occlusion(lumigraph, modes[i]))
            shares[i] = occlusion_share(lumigraph, path, modes[i], *context.progress);
    if (context.json) {
        context.print_result(report_json(report, lookups, shares));
    } else {
        context.print_result(report_text(report, lookups, shares));
    }
}

}  // namespace

void add_bench_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "bench", "Frame times, as a ratio to a blend of three textures",
                    "lumi bench work/demo/demo.lumi --json\n"
                    "         lumi bench work/demo/demo.lumi --fps 5,10,20,40");
    const auto request = std::make_shared<BenchRequest>();
    command.add_option("PACKAGE", request->package, "Folder NAME.lumi")->required();
    CLI::Option* size =
        command.add_option("--size", request->size, "Of the frames")->capture_default_str();
    CLI::Option* path =
        command
            .add_option(
                "--path", request->path,
                "Straight from photograph to photograph (the word views), or a path that the "
                "window recorded (a JSON file)")
            ->capture_default_str();
    CLI::Option* mode = command
                            .add_option("--mode", request->modes,
                                        render_mode_names() +
                                            ", also several, with commas between; all of them "
                                            "without")
                            ->delimiter(',');
    CLI::Option* frames = command.add_option("--frames", request->frames, "Of the path `views`")
                              ->check(CLI::Range(2, 100000))
                              ->capture_default_str();
    CLI::Option* share = command.add_flag(
        "--occlusion-share", request->occlusion_share,
        "Also how much of a frame the occlusion correction takes: each is drawn with "
        "it and without in turn");
    command
        .add_option("--fps", request->frames_per_second,
                    "Instead: adaptive within time budgets, so many frames a second each, and what "
                    "comes of it: frames a second, triangles, dB of the held-out photographs that "
                    "lie beside the package")
        ->delimiter(',')
        ->check(positive_number())
        ->excludes(size, path, mode, frames, share);
    command.callback([request, &context] {
        context.chosen = [request, &context] {
            request->frames_per_second.empty() ? run_bench(*request, context)
                                               : run_frame_rate_sweep(*request, context);
        };
    });
}

}  // namespace lumi
