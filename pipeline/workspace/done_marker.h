#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/stopwatch.h"
#include "pipeline/workspace/content.h"

namespace lumi {

/// What decides the result of a stage. Two runs with equal identities may share a result.
struct StageIdentity {
    std::string stage;
    std::string code;           ///< Version of the code that does the work.
    std::string parameters;     ///< Canonical text of every option that matters.
    std::string external_tool;  ///< Version of the program that is driven; "" when none is.
    std::string inputs;         ///< Hash over names and contents.
};

/// SHA-256 over the parts.
[[nodiscard]] std::string stage_key(const StageIdentity& identity);

/// What speaks for a finished stage, as JSON objects. `facts_json` is the same in every run and may
/// go into the package; `timings_json` is not.
struct StageEvidence {
    std::string facts_json = "{}";
    std::string timings_json = "{}";
};

/// The last file that a stage writes: it says what was made, and from what.
struct DoneMarker {
    StageIdentity identity;
    std::vector<ContentEntry> outputs;  ///< Named relative to the workspace.
    Cost cost;
    StageEvidence evidence;
};

void write_done_marker(const std::filesystem::path& path, const DoneMarker& marker);
/// Empty when there is none, or when it is damaged: then the stage is not done.
[[nodiscard]] std::optional<DoneMarker> read_done_marker(const std::filesystem::path& path);

}  // namespace lumi
