#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/process_memory.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/eye_path.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/report/number_text.h"
#include "pipeline/report/optional_json.h"
#include "pipeline/report/padded.h"
#include "render/bench/frame_timing.h"
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

Json report_json(const FrameTimingReport& report, const OcclusionShares& shares) {
    Json modes = Json::object();
    for (std::size_t i = 0; i < report.modes.size(); ++i) {
        const ModeCost& mode = report.modes[i];
        modes[name_of(mode.options.mode)] = {
            {"ratio", mode.ratio},
            {"cpu_ratio", mode.cpu_ratio},
            {"ms", mode.cost.median_ms},
            {"p95_ms", mode.cost.p95_ms},
            {"cpu_ms", mode.cost.cpu_ms},
            {"device_ms", optional_json(mode.device_ms)},
            {"triangles", mode.triangles},
            {"fragments_per_pixel", optional_json(mode.fragments_per_pixel)},
            {"occlusion_share", optional_json(shares[i])}};
    }
    return Json{{"base_ms", report.base.median_ms},
                {"base_cpu_ms", report.base.cpu_ms},
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

std::string report_text(const FrameTimingReport& report, const OcclusionShares& shares) {
    constexpr double kBytesPerMebibyte = 1024.0 * 1024.0;
    std::string text =
        std::to_string(report.frames) + " frames of " + std::to_string(report.width_px) + "x" +
        std::to_string(report.height_px) + " on " + report.gl_description + ", " +
        std::to_string(report.threads) + " threads, " +
        number_text(static_cast<double>(report.texture_bytes) / kBytesPerMebibyte, 0) +
        " MiB of textures\n" + padded_right("medians", 24) + padded_left("CPU ms", 8) +
        padded_left("wall ms", 9) + padded_left("95 %", 9) + padded_left("blends", 9) +
        padded_left("(wall)", 9) + padded_left("triangles", 11) + padded_left("fragments", 11) +
        "\n" + row_text("blend of three textures", report.base, 1, 1) + "\n";
    for (const ModeCost& mode : report.modes) {
        const std::optional<double>& fragments = mode.fragments_per_pixel;
        text += row_text(name_of(mode.options.mode), mode.cost, mode.cpu_ratio, mode.ratio) +
                padded_left(number_text(mode.triangles, 0), 11) +
                padded_left(fragments ? number_text(*fragments, 2) : "-", 11) + "\n";
    }
    text +=
        "blends: times the blend of three textures, by CPU time and by wall time;\n"
        "fragments: a pixel of the picture, in all passes\n";
    text += device_text(report);
    for (std::size_t i = 0; i < shares.size(); ++i)
        if (shares[i])
            text += "occlusion correction takes " + number_text(100 * *shares[i], 1) + " % of " +
                    name_of(report.modes[i].options.mode) + " (the paper: 7 to 10 %)\n";
    return text;
}

void run_bench(const BenchRequest& request, const CommandContext& context) {
    const std::vector<RenderOptions> modes = options_of(request.modes);
    const Lumigraph lumigraph = read_package(request.package);
    keep_free_memory();
    const std::vector<Eye> path = eye_path(request.path, request.frames, request.size, lumigraph);
    const FrameTimingReport report = time_frames(lumigraph, path, modes, *context.progress);
    OcclusionShares shares(modes.size());
    for (std::size_t i = 0; request.occlusion_share && i < modes.size(); ++i)
        if (corrects_occlusion(modes[i].mode))
            shares[i] = occlusion_share(lumigraph, path, modes[i], *context.progress);
    if (context.json) {
        context.print_result(report_json(report, shares));
    } else {
        context.print_result(report_text(report, shares));
    }
}

}  // namespace

void add_bench_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "bench", "Frame times, as a ratio to a blend of three textures",
                    "lumi bench work/demo/demo.lumi --json");
    const auto request = std::make_shared<BenchRequest>();
    command.add_option("PACKAGE", request->package, "Folder NAME.lumi")->required();
    command.add_option("--size", request->size, "Of the frames")->capture_default_str();
    command
        .add_option("--path", request->path,
                    "From photograph to photograph (the word views), or a path that the window "
                    "recorded (a JSON file)")
        ->capture_default_str();
    command.add_option("--mode", request->modes,
                       render_mode_names() + ", also several; all of them without");
    command.add_option("--frames", request->frames, "Of the path `views`")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command.add_flag("--occlusion-share", request->occlusion_share,
                     "Also how much of a frame the occlusion correction takes: each is drawn with "
                     "it and without in turn");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench(*request, context); };
    });
}

}  // namespace lumi
