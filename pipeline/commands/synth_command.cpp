#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/stopwatch.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/synth/synthesize.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

void run_synth(const std::filesystem::path& scene, const std::filesystem::path& out,
               const CommandContext& context) {
    require_writable_folder(out);
    const SceneDescription description = scene.empty()
                                             ? read_scene_description(ConfigSection::from_text(
                                                   demo_scene_toml(), "the demo scene within lumi"))
                                             : read_scene_description(scene);
    const Stopwatch stopwatch;
    synthesize_into(out, description, context.threads, *context.progress);
    if (context.json) {
        context.print_result(Json{{"photographs", (out / "photos").string()},
                                  {"truth", (out / "truth").string()},
                                  {"wall_s", stopwatch.elapsed().wall_s}});
    } else {
        context.print_result((out / "photos").string() + "\n" + (out / "truth").string() + "\n");
    }
}

}  // namespace

void add_synth_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "synth", "Photographs of a described scene, and their truth",
                    "lumi synth configs/demo-scene.toml --out work/demo-scene");
    const auto scene = std::make_shared<std::filesystem::path>();
    const auto out = std::make_shared<std::filesystem::path>();
    command.add_option("SCENE", *scene, "Description of the scene (default: that of the demo)");
    command.add_option("--out", *out, "Folder for photos/ and truth/")->required();
    command.callback([scene, out, &context] {
        context.chosen = [scene, out, &context] { run_synth(*scene, *out, context); };
    });
}

}  // namespace lumi
