#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_build.h"
#include "pipeline/commands/run_dataset_build.h"
#include "pipeline/commands/run_target.h"
#include "pipeline/dataset/dataset.h"

namespace lumi {

void add_build_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "build", "Photographs to package: all stages, skipping what is up to date",
                    "lumi build configs/fountain.toml\n         lumi build photos/\n"
                    "         lumi build walk.mp4\n"
                    "         lumi build configs/demo.toml --target 30dB\n"
                    "         lumi build configs/arena.toml");
    const auto request = std::make_shared<BuildRequest>();
    const auto wish = std::make_shared<std::string>();
    command
        .add_option("CONFIG", request->config,
                    "Configuration file, a folder of photographs, a video, or a dataset file")
        ->required();
    command.add_option("--workspace", request->workspace, "Where to work (default: work/NAME)");
    command.add_option("--target", *wish,
                       "30fps, 30dB, 50MiB, 5min: measure the sweep and build what meets it");
    command.footer(
        "WORKSPACE/config.toml lists every key of a configuration with its value, what it means, "
        "and which\nvalues it takes.\n"
        "Exit code 5: the package is there, but fewer than four fifths of the photographs are in "
        "it.");
    command.callback([request, wish, &context] {
        context.chosen = [request, wish, &context] {
            if (!wish->empty()) return run_target(*request, *wish, context);
            if (is_dataset_file(request->config)) return run_dataset_build(*request, context);
            run_build(*request, "pack", context);
        };
    });
}

}  // namespace lumi
