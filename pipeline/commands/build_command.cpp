#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_build.h"

namespace lumi {

void add_build_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "build", "Photographs to package: all stages, skipping what is up to date",
                    "lumi build configs/fountain.toml\n         lumi build photos/");
    const auto request = std::make_shared<BuildRequest>();
    command.add_option("CONFIG", request->config, "Configuration file, or a folder of photographs")
        ->required();
    command.add_option("--workspace", request->workspace, "Where to work (default: work/NAME)");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_build(*request, "pack", context); };
    });
}

}  // namespace lumi
