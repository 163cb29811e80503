#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/process_memory.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/frame_size.h"
#include "pipeline/commands/number_checks.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/optional_json.h"
#include "render/lumigraph/package.h"
#include "render/viewer/orbit_endurance.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kBytesPerMebibyte = 1024.0 * 1024.0;
/// Of the warm-up, in which all photographs are gone to.
constexpr double kRoundShare = 5.0 / 6.0;

struct BenchOrbitRequest {
    std::filesystem::path package;
    std::string size = "1280x720";
    double minutes = 10.0;
    double warm_up_minutes = 1.0;
    std::vector<std::string> modes = {"perpixel", "adaptive"};
};

double mebibytes(std::uint64_t bytes) { return static_cast<double>(bytes) / kBytesPerMebibyte; }

/// Of the window after the warm-up; below 0 where it gave memory back.
std::optional<double> growth_mib(const OrbitReport& report, const OrbitOptions& options) {
    const std::optional<std::int64_t> bytes = report.growth_bytes(options.warm_up_s);
    if (!bytes) return std::nullopt;
    return static_cast<double>(*bytes) / kBytesPerMebibyte;
}

std::uint64_t most_while_moving(const OrbitReport& report) {
    std::uint64_t most = 0;
    for (const MemorySample& sample : report.memory) most = std::max(most, sample.moving_bytes);
    return most;
}

Json report_json(const OrbitReport& report, const OrbitOptions& options) {
    Json memory = Json::array();
    for (const MemorySample& sample : report.memory)
        memory.push_back({{"seconds", sample.seconds},
                          {"moving_mib", mebibytes(sample.moving_bytes)},
                          {"mib", mebibytes(sample.bytes)}});
    return Json{{"frames", report.frames},
                {"seconds", report.seconds},
                {"median_frame_ms", report.median_frame_ms},
                {"p95_frame_ms", report.p95_frame_ms},
                {"longest_frame_ms", report.longest_frame_ms},
                {"gl_errors", report.gl_errors},
                {"warm_up_s", options.warm_up_s},
                {"growth_mib", optional_json(growth_mib(report, options))},
                {"memory", std::move(memory)}};
}

std::string report_text(const OrbitReport& report, const OrbitOptions& options) {
    const std::optional<double> growth = growth_mib(report, options);
    return counted(report.frames, "frame") + " in " + number_text(report.seconds, 0) +
           " s; while moving a median of " + number_text(report.median_frame_ms, 1) +
           " ms, 95 % within " + number_text(report.p95_frame_ms, 1) + " ms, all within " +
           number_text(report.longest_frame_ms, 0) + " ms\n" +
           counted(report.gl_errors, "OpenGL error") + "\n" +
           number_text(mebibytes(report.memory.back().bytes), 1) + " MiB at rest at the end" +
           (growth ? ", " + number_text(*growth, 2) + " more than after the first " +
                         number_text(options.warm_up_s, 0) + " s"
                   : "") +
           "; " + number_text(mebibytes(most_while_moving(report)), 1) + " at most while moving\n";
}

void run_bench_orbit(const BenchOrbitRequest& request, const CommandContext& context) {
    constexpr double kSecondsPerMinute = 60.0;
    if (request.warm_up_minutes >= request.minutes)
        throw Error(ErrorKind::kUsage, "E-ORBIT-WARM-UP",
                    "the warm-up lasts as long as all of it, so that nothing is left to measure",
                    "give more --minutes, or fewer of --warm-up");
    OrbitOptions options;
    options.seconds = kSecondsPerMinute * request.minutes;
    options.warm_up_s = kSecondsPerMinute * request.warm_up_minutes;
    if (options.warm_up_s > 0)
        options.round_s = std::min(options.round_s, kRoundShare * options.warm_up_s);
    options.modes.clear();
    for (const std::string& name : request.modes) options.modes.push_back(render_mode_from(name));

    const FrameSize size = frame_size_from(request.size);
    WindowOptions window_options;
    window_options.width_px = size.width_px;
    window_options.height_px = size.height_px;
    Lumigraph lumigraph = read_package(request.package);
    keep_free_memory();
    const std::size_t photographs = lumigraph.views.size();
    ViewerWindow window({std::move(lumigraph)}, window_options);
    const OrbitReport report = orbit_window(window, photographs, options, *context.progress);
    if (context.json) {
        context.print_result(report_json(report, options));
    } else {
        context.print_result(report_text(report, options));
    }
}

}  // namespace

void add_bench_orbit_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "bench-orbit",
                    "Memory, OpenGL errors and frame times of the window, by minutes of orbiting",
                    "lumi bench-orbit work/demo/demo.lumi");
    const auto request = std::make_shared<BenchOrbitRequest>();
    command.add_option("PACKAGE", request->package, "Folder NAME.lumi")->required();
    command.add_option("--minutes", request->minutes, "In all")
        ->check(number_from_to(0.01, 10000.0))
        ->capture_default_str();
    command
        .add_option("--warm-up", request->warm_up_minutes,
                    "Minutes whose growth of memory is not counted")
        ->check(number_from_to(0.0, 10000.0))
        ->capture_default_str();
    command.add_option("--size", request->size, "Of the window")->capture_default_str();
    command
        .add_option(
            "--mode", request->modes,
            "Several, with commas between, take turns at each photograph: " + render_mode_names())
        ->delimiter(',')
        ->capture_default_str();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench_orbit(*request, context); };
    });
}

}  // namespace lumi
