#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/frame_size.h"
#include "pipeline/report/number_text.h"
#include "render/bench/frame_timing.h"
#include "render/lumigraph/package.h"
#include "render/paths/path_through_views.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

struct BenchRequest {
    std::filesystem::path package;
    std::string size = "1280x720";
    int frames = 60;
};

Json report_json(const FrameTimingReport& report) {
    Json modes = Json::object();
    for (const ModeCost& mode : report.modes) {
        modes[name_of(mode.options.mode)] = {
            {"ratio", mode.ratio},        {"cpu_ratio", mode.cpu_ratio},
            {"ms", mode.cost.median_ms},  {"p95_ms", mode.cost.p95_ms},
            {"cpu_ms", mode.cost.cpu_ms}, {"triangles", mode.triangles}};
    }
    return Json{{"base_ms", report.base.median_ms},
                {"size", {report.width_px, report.height_px}},
                {"frames", report.frames},
                {"gl_renderer", report.gl_description},
                {"modes", std::move(modes)}};
}

std::string report_text(const FrameTimingReport& report) {
    std::string text =
        "blend of three textures  " + number_text(report.base.median_ms, 2) + " ms\n";
    for (const ModeCost& mode : report.modes) {
        text += name_of(mode.options.mode) + "  " + number_text(mode.cost.median_ms, 2) +
                " ms (95 %: " + number_text(mode.cost.p95_ms, 2) + " ms), " +
                number_text(mode.ratio, 2) + " times the blend\n";
    }
    return text;
}

void run_bench(const BenchRequest& request, const CommandContext& context) {
    const FrameSize size = frame_size_from(request.size);
    const Lumigraph lumigraph = read_package(request.package);
    std::vector<RenderOptions> modes;
    for (const RenderMode mode : all_render_modes()) modes.push_back({.mode = mode});
    const FrameTimingReport report = time_frames(
        lumigraph, path_through_views(lumigraph, request.frames, size.width_px, size.height_px),
        modes, *context.progress);
    if (context.json) {
        context.print_result(report_json(report));
    } else {
        context.print_result(report_text(report));
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
    command.add_option("--frames", request->frames, "Along a path from view to view")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench(*request, context); };
    });
}

}  // namespace lumi
