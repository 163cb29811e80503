#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/config/config_variant.h"
#include "pipeline/evaluate/evaluation.h"

namespace lumi {

/// Every photograph judged by a package that was made without it; the poses are those of all.
struct LeaveOneOut {
    std::vector<std::string> photographs;  ///< Those that have a place.
    /// The photograph is left out of the camera mesh, but the depth of the others was found with
    /// it.
    Evaluation depth_kept;
    /// It is left out of everything but the poses; no modes when that was not asked for.
    Evaluation depth_removed;
};

/// Works in `folder`, where all packages share ingest and poses; what was made before is not made
/// again. Removing the depth, too, takes the depth stage as many times as there are photographs.
/// Photographs are drawn with these exposures, in these modes.
/// Throws Error (as WorkFolder, run_line and evaluate_held_out do; E-EVAL-FEW for fewer than three
/// placed photographs).
[[nodiscard]] LeaveOneOut leave_one_out(const ConfigDocument& document,
                                        const std::vector<RenderMode>& modes, Exposures exposures,
                                        bool remove_depth, const std::filesystem::path& folder,
                                        int threads, Progress& progress);

}  // namespace lumi
