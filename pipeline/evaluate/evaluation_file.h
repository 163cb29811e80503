#pragma once

#include <nlohmann/json_fwd.hpp>

#include "pipeline/evaluate/evaluation.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// What evaluation.json says: "mode", "gl", "mean" and "views" of the first mode, and every further
/// mode under "modes". A covered PSNR without a covered pixel is null.
[[nodiscard]] nlohmann::ordered_json evaluation_json(const Evaluation& evaluation);

/// What tells one package from another: the hash of its manifest, which has the hash of every file.
[[nodiscard]] std::string package_sha256(const WorkspaceLayout& workspace);

/// The evaluation in the workspace; null when there is none, or when it is of another package than
/// the one that stands there now.
[[nodiscard]] nlohmann::ordered_json read_current_evaluation(const WorkspaceLayout& workspace);

}  // namespace lumi
