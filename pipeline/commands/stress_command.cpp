#include <CLI/CLI.hpp>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/run_perturbations.h"

namespace lumi {

void add_stress_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "stress",
        "Perturbs poses, lens, depth, exposure, sharpness and views until pictures break",
        "lumi stress configs/demo.toml\n         lumi stress work/demo/demo.lumi");
    const auto request = std::make_shared<PerturbationRequest>();
    command
        .add_option("SUBJECT", request->subject,
                    "Configuration (built first), workspace, or package")
        ->required();
    command.add_option("--out", request->out, "Where results go (default: WORKSPACE/stress)");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_perturbations(*request, context); };
    });
}

}  // namespace lumi
