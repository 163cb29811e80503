#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_build.h"

namespace lumi {
namespace {

void add_stage_command(CLI::App& app, CommandContext& context, const std::string& stage,
                       const std::string& description) {
    CLI::App& command = add_command(app, stage, description + ", and what it needs before",
                                    "lumi " + stage + " configs/fountain.toml");
    const auto request = std::make_shared<BuildRequest>();
    command
        .add_option("CONFIG", request->config,
                    "Configuration file, a folder of photographs, or a video")
        ->required();
    command.add_option("--workspace", request->workspace, "Where to work (default: work/NAME)");
    command.callback([request, stage, &context] {
        context.chosen = [request, stage, &context] { run_build(*request, stage, context); };
    });
}

}  // namespace

void add_stage_commands(CLI::App& app, CommandContext& context) {
    add_stage_command(app, context, "ingest", "Photographs to working copies");
    add_stage_command(app, context, "poses", "Where each photograph was taken from");
    add_stage_command(app, context, "mesh", "The surface that the cameras span");
    add_stage_command(app, context, "depth", "How far away each pixel is");
    add_stage_command(app, context, "pack", "Everything into one package");
}

}  // namespace lumi
