#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "pipeline/evaluate/evaluation.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// The version of evaluation.json; evaluation.schema.json beside this file describes it.
constexpr int kEvaluationSchemaVersion = 4;

/// What evaluation.json says: "mode", "gl", "not_judged", "bootstrap", "mean", "interval",
/// "interior", "border", "ghost" and "views" of the first mode, every further mode under "modes",
/// and other methods under "rivals". What a view or a group of views does not have is null, as are
/// rivals that were not asked for.
[[nodiscard]] nlohmann::ordered_json evaluation_json(const Evaluation& evaluation);

/// "evened" or "as taken", as files say it.
[[nodiscard]] std::string name_of(Exposures exposures);

/// What decides an evaluation beside the package and the photographs, as "made_with" in the file of
/// a workspace: "modes", "exposures", "ghost_energy", "rivals", and "code", the version of the
/// code that draws and judges.
[[nodiscard]] nlohmann::ordered_json made_with_json(const EvaluationOptions& options,
                                                    const std::string& code_version);

/// The same of one mode.
[[nodiscard]] nlohmann::ordered_json mode_scores_json(const ModeScores& scores);
/// The scores of views read back, but for what tells which photographs they are of. Throws
/// nlohmann::json::exception.
[[nodiscard]] ModeScores mode_scores_from(RenderMode mode, const nlohmann::ordered_json& json);

/// What tells one package from another: the hash of its manifest, which has the hash of every file.
[[nodiscard]] std::string package_sha256(const WorkspaceLayout& workspace);

/// An evaluation from a file, or from the workspace whose folder is named, where it must be of the
/// package, the photographs and the depth that stand there now. Throws Error (E-JSON-READ,
/// E-EVAL-NONE: there is none, E-EVAL-SCHEMA: another version, E-EVAL-STALE: of others, or of a
/// version of lumi that did not say of which, E-FILE-READ, E-WORKSPACE-NONE).
[[nodiscard]] nlohmann::ordered_json read_evaluation(const std::filesystem::path& file_or_folder);

/// The evaluation in the workspace; null when there is none, when it or the record of the package
/// is damaged, or when read_evaluation would refuse it as stale. What it was made with may be
/// anything.
[[nodiscard]] nlohmann::ordered_json read_current_evaluation(const WorkspaceLayout& workspace);

}  // namespace lumi
