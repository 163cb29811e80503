#pragma once

#include <filesystem>

#include "pipeline/commands/command_context.h"

namespace lumi {

/// What is perturbed.
struct PerturbationRequest {
    std::filesystem::path subject;  ///< A configuration (built first), a workspace or a package.
    std::filesystem::path out;      ///< Empty: WORKSPACE/stress.
};

/// `lumi stress SUBJECT`: perturbs a package in every way and writes what each costs. Throws Error.
void run_perturbations(const PerturbationRequest& request, const CommandContext& context);

}  // namespace lumi
