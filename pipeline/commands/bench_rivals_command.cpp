#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "calib/work/process_memory.h"
#include "pipeline/bench/rival_benchmark.h"
#include "pipeline/bench/rival_scenes.h"
#include "pipeline/commands/commands.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/optional_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

struct BenchRivalsRequest {
    RivalBenchmarkOptions options;
    std::vector<std::string> scenes;
};

Json rival_json(const RivalFigures& rival) {
    return {{"method", rival.method},
            {"settings", rival.settings},
            {"pictures", rival.pictures},
            {"triangles", rival.triangles},
            {"cpu_ms", optional_json(rival.cpu_ms)},
            {"wall_ms", optional_json(rival.wall_ms)},
            {"cpu_ratio", optional_json(rival.cpu_ratio)},
            {"psnr_db", rival.psnr_db},
            {"psnr_covered_db", rival.psnr_covered_db},
            {"coverage", rival.coverage},
            {"wrong_layer_share", rival.wrong_layer_share},
            {"avoidable_wrong_layer_share", rival.avoidable_wrong_layer_share},
            {"flicker", optional_json(rival.flicker)}};
}

Json report_json(const std::vector<RivalScene>& scenes) {
    Json list = Json::array();
    for (const RivalScene& scene : scenes) {
        Json rivals = Json::array();
        for (const RivalFigures& rival : scene.rivals) rivals.push_back(rival_json(rival));
        list.push_back({{"scene", scene.name},
                        {"photographs", scene.photographs},
                        {"paper", scene.paper},
                        {"resampling_cpu_s", scene.resampling_cpu_s},
                        {"adaptive_occlusion_share", scene.adaptive_occlusion_share},
                        {"per_pixel_occlusion_share", scene.per_pixel_occlusion_share},
                        {"rivals", std::move(rivals)}});
    }
    return {{"scenes", std::move(list)}};
}

std::string row_text(const RivalFigures& rival) {
    std::string name = rival.method + (rival.settings.empty() ? "" : ", " + rival.settings);
    name.resize(std::max<std::size_t>(name.size(), 38), ' ');
    const auto cell = [](const std::optional<double>& value, int digits) {
        return padded_left(value ? number_text(*value, digits) : "-", 10);
    };
    return name + padded_left(number_text(rival.triangles, 0), 8) + cell(rival.cpu_ms, 2) +
           cell(rival.wall_ms ? std::optional(1000 / *rival.wall_ms) : std::nullopt, 0) +
           cell(rival.cpu_ratio, 2) + cell(rival.psnr_db, 2) + cell(rival.psnr_covered_db, 2) +
           cell(100 * rival.coverage, 1) + cell(100 * rival.wrong_layer_share, 3) +
           cell(100 * rival.avoidable_wrong_layer_share, 3) + cell(rival.flicker, 3) + "\n";
}

std::string report_text(const std::vector<RivalScene>& scenes) {
    std::string text;
    for (const RivalScene& scene : scenes) {
        text += scene.name + ": " + counted(scene.photographs, "photograph") +
                " (the paper: " + scene.paper + ")\n";
        std::string head = "method";
        head.resize(38, ' ');
        text += head +
                "   tris    CPU ms  frames/s     ratio        dB  (cover.)   cover %   wrong % "
                "avoidable" +
                "   flicker\n";
        for (const RivalFigures& rival : scene.rivals) text += row_text(rival);
        text += "occlusion correction takes " +
                number_text(100 * scene.adaptive_occlusion_share, 1) + " % of adaptive, " +
                number_text(100 * scene.per_pixel_occlusion_share, 1) +
                " % of perpixel (the paper: 7 to 10 %); resampling to two planes took " +
                number_text(scene.resampling_cpu_s, 1) +
                " CPU s, and what is resampled is drawn by lumi's own modes\n\n";
    }
    return text;
}

void run_bench_rivals(const BenchRivalsRequest& request, const CommandContext& context) {
    keep_free_memory();
    const std::vector<RivalScene> scenes = benchmark_rivals(
        request.options, request.scenes.empty() ? rival_scene_names() : request.scenes,
        *context.progress);
    if (context.json) {
        context.print_result(report_json(scenes));
    } else {
        context.print_result(report_text(scenes));
    }
}

}  // namespace

void add_bench_rivals_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "bench-rivals", "The paper's three scenes, drawn by lumi and by the methods it names",
        "lumi bench-rivals --scene coke");
    const auto request = std::make_shared<BenchRivalsRequest>();
    command.add_option("--scene", request->scenes, "coke, petruschka, statue (default: all)")
        ->check(CLI::IsMember(rival_scene_names()));
    command
        .add_option("--size", request->options.size_px, "Side of photographs and frames, pixels")
        ->check(CLI::Range(64, 2048))
        ->capture_default_str();
    command.add_option("--frames", request->options.frames, "Timed for each method")
        ->check(CLI::Range(2, 10000))
        ->capture_default_str();
    command.add_option("--held-out", request->options.held_out, "Photographs to measure against")
        ->check(CLI::Range(2, 1000))
        ->capture_default_str();
    command
        .add_option("--flicker-frames", request->options.flicker_frames,
                    "Of a path with known truth; 0: none")
        ->check(CLI::Range(0, 100000))
        ->capture_default_str();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench_rivals(*request, context); };
    });
}

}  // namespace lumi
