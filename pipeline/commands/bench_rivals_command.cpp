#include <CLI/CLI.hpp>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/process_memory.h"
#include "pipeline/bench/rival_pictures.h"
#include "pipeline/bench/rival_report.h"
#include "pipeline/bench/rival_scenes.h"
#include "pipeline/commands/commands.h"

namespace lumi {
namespace {

struct BenchRivalsRequest {
    RivalBenchmarkOptions options;
    std::vector<std::string> scenes;
    std::filesystem::path out;
};

void run_bench_rivals(const BenchRivalsRequest& request, const CommandContext& context) {
    const std::vector<std::string> names =
        request.scenes.empty() ? rival_scene_names() : request.scenes;
    std::optional<RivalPictureFiles> pictures;
    if (!request.out.empty()) {
        require_writable_folder(request.out);
        pictures.emplace(request.out, names);
    }
    keep_free_memory();
    const std::vector<RivalScene> scenes = benchmark_rivals(
        request.options, names,
        [&](const RivalPicture& picture) {
            if (pictures) pictures->write(picture);
        },
        *context.progress);
    if (context.json) {
        context.print_result(rival_scenes_json(scenes));
    } else {
        context.print_result(rivals_text(scenes));
    }
    if (!pictures) return;
    pictures->put_in_place();
    write_rival_report(request.out, scenes);
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
    command.add_option("--out", request->out,
                       "Also write here rivals.json and rivals.csv, each frame of each method, and "
                       "what each method draws, as it draws it: SCENE/frame-N.METHOD.png");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench_rivals(*request, context); };
    });
}

}  // namespace lumi
