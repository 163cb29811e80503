#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numeric>

#include "calib/work/error.h"
#include "calib/work/median.h"
#include "calib/work/whole_file.h"
#include "pipeline/bench/flicker_files.h"
#include "pipeline/bench/rival_scenes.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/frame_size.h"
#include "pipeline/text/number_text.h"
#include "render/lumigraph/package.h"
#include "render/paths/path_past_border.h"

namespace lumi {
namespace {

struct BenchFlickerRequest {
    std::filesystem::path package;
    std::string scene;
    std::filesystem::path out;
    std::string size = "160x120";
    int frames = 1000;
};

std::string row_text(const FlickerFigures& figures) {
    const auto cell = [](const std::optional<double>& value, int digits) {
        std::string text = value ? number_text(*value, digits) : "-";
        if (text.size() < 10) text.insert(0, 10 - text.size(), ' ');
        return text;
    };
    const std::vector<double>& changes = figures.changes;
    const double sum = std::accumulate(changes.begin(), changes.end(), 0.0);
    std::string name = figures.mode;
    name.resize(std::max<std::size_t>(name.size(), 18), ' ');
    return name + cell(figures.flicker, 3) + cell(figures.worst_flicker, 2) +
           cell(sum / static_cast<double>(changes.size()), 3) +
           cell(quantile_of(changes, 0.99), 2) +
           cell(*std::max_element(changes.begin(), changes.end()), 2) +
           cell(figures.jump.change, 3) + cell(100 * figures.jump.pixel_share, 2) +
           cell(static_cast<double>(figures.jump.frame), 0) + "\n";
}

std::string report_text(const std::vector<FlickerFigures>& all) {
    std::string text =
        "                     flicker     worst    change      99 %   largest      jump  pixels %  "
        "at "
        "frame\n";
    for (const FlickerFigures& figures : all) text += row_text(figures);
    return text;
}

std::vector<FlickerFigures> measured(const BenchFlickerRequest& request,
                                     const CommandContext& context) {
    const FrameSize size = frame_size_from(request.size);
    const auto path_for = [&](const Lumigraph& lumigraph) {
        return path_past_border(lumigraph, request.frames, size.width_px, size.height_px);
    };
    if (request.scene.empty()) {
        const Lumigraph lumigraph = read_package(request.package);
        return benchmark_flicker(lumigraph, path_for(lumigraph), {}, *context.progress);
    }
    const RivalCaptureOptions options{.path_frames = 0};
    const RivalCapture capture = rival_capture(request.scene, options, *context.progress);
    return benchmark_flicker(
        capture.lumigraph, path_for(capture.lumigraph),
        [&](const Eye& eye) { return true_picture(request.scene, options, eye); },
        *context.progress);
}

void run_bench_flicker(const BenchFlickerRequest& request, const CommandContext& context) {
    if (request.package.empty() == request.scene.empty())
        throw Error(ErrorKind::kUsage, "E-FLICKER-INPUT",
                    "a package or a scene is wanted, one of them",
                    "lumi bench-flicker work/demo/demo.lumi, or lumi bench-flicker --scene coke");
    if (!request.out.empty()) require_writable_folder(request.out);
    const std::vector<FlickerFigures> all = measured(request, context);
    if (!request.out.empty()) {
        write_flicker_files(request.out, all, *context.progress);
        context.say((request.out / "flicker.svg").string() + "\n");
    }
    if (context.json) {
        context.print_result(flicker_json(all));
    } else {
        context.print_result(report_text(all));
    }
}

}  // namespace

void add_bench_flicker_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "bench-flicker",
                    "How pictures change along a path through the mesh and past its border",
                    "lumi bench-flicker --scene coke --out work/flicker");
    const auto request = std::make_shared<BenchFlickerRequest>();
    command.add_option("PACKAGE", request->package, "Folder NAME.lumi");
    command
        .add_option("--scene", request->scene,
                    "Instead of a package a scene of which the truth is known: coke, petruschka, "
                    "statue")
        ->check(CLI::IsMember(rival_scene_names()));
    command.add_option("--out", request->out,
                       "Folder for flicker.json, flicker.svg and pictures of the largest jumps");
    command.add_option("--size", request->size, "Of the frames")->capture_default_str();
    command.add_option("--frames", request->frames, "Along the path")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench_flicker(*request, context); };
    });
}

}  // namespace lumi
