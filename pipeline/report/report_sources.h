#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "pipeline/report/standing_package.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// What a report is made from.
struct ReportSources {
    WorkspaceLayout workspace;
    nlohmann::ordered_json stages;  ///< As in stages.json.
    StandingPackage package;
    /// As in evaluation.json; null when there is none of a package that the configuration asks for.
    nlohmann::ordered_json evaluation;
    nlohmann::ordered_json target;  ///< As in target.json; the same.
};

/// Rows of a table, cell by cell.
using TableRows = std::vector<std::vector<std::string>>;

/// The evidence of a stage, or another part of what stages.json says; null when the stage is not
/// there.
[[nodiscard]] nlohmann::ordered_json evidence_of(const nlohmann::ordered_json& stages,
                                                 const std::string& stage,
                                                 const char* part = "evidence");

/// A JSON value as a reader sees it: texts without quotation marks, three decimals.
[[nodiscard]] std::string text_of(const nlohmann::ordered_json& value);

/// Names and plain values of an object as a table, one a row; lists and objects stand elsewhere.
[[nodiscard]] std::string table_of_values(const nlohmann::ordered_json& object);

}  // namespace lumi
