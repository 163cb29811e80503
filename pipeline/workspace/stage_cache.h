#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/workspace/done_marker.h"
#include "pipeline/workspace/stage_store.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// A piece of the line: what decides its result, and how the result is made.
struct Stage {
    StageIdentity identity;
    /// Writes into the folder it is given and nowhere else, `product` excepted.
    std::function<StageEvidence(const std::filesystem::path& folder)> run;
    /// A folder that `run` itself puts in place whole, outside its own (the package); may be empty.
    std::filesystem::path product;
    /// Whether a name below the product, '/' between folders, is that of a file which `run` writes;
    /// all are where nothing says so. Others are somebody's, and no output.
    std::function<bool(const std::string&)> is_of_product = {};
};

/// How a stage came to be finished.
struct FinishedStage {
    std::string name;
    bool was_run = false;
    std::string reason;  ///< Why it was run: "parameters changed", ...
    Cost cost;           ///< Of the run that made the result.
    StageEvidence evidence;
    std::vector<ContentEntry> outputs;
};

/// Runs a stage unless a finished result with the same identity and unharmed files stands in the
/// workspace. A result appears by one rename: killed at any moment, a stage is done or not begun;
/// what else somebody put into the folder of a finished stage is kept. With a store, a result that
/// is kept there is taken instead of running a stage without a product, and what was run, or what
/// ended it, is kept there.
[[nodiscard]] FinishedStage bring_up_to_date(const Workspace& workspace, const Stage& stage,
                                             int threads, Progress& progress,
                                             StageStore* store = nullptr);

}  // namespace lumi
