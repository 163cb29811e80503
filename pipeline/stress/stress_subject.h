#pragma once

#include <filesystem>

#include "pipeline/stress/run_stress.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// The package of a workspace and its held-out photographs. Throws Error (E-EVAL-...,
/// E-PACKAGE-...).
[[nodiscard]] StressSubject subject_of_workspace(const WorkspaceLayout& workspace, int threads);

/// A package by itself: every fourth view is left out of the camera mesh and compared with. The
/// depth of the others was found with them, so that curves start a little too high. Throws Error
/// (E-PACKAGE-..., E-STRESS-FEW for fewer than five views).
[[nodiscard]] StressSubject subject_of_package(const std::filesystem::path& package);

}  // namespace lumi
