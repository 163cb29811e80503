#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/work/error.h"
#include "calib/work/progress.h"
#include "pipeline/dataset/dataset.h"
#include "pipeline/evaluate/view_score.h"
#include "pipeline/line/placed_photographs.h"

namespace lumi {

/// What became of a scene.
struct SceneOutcome {
    std::string name;
    std::optional<Error> failure;  ///< Empty when it was built.
    PlacedPhotographs photographs;
    double cpu_s = 0.0;  ///< Of all stages, whenever they were run.
    double wall_s = 0.0;
    double package_mib = 0.0;
    std::optional<ViewScore> mean;  ///< Empty when nothing was held out.
    std::optional<Interval> flip_interval;
};

/// Builds every scene in FOLDER/NAME, evaluates those with held-out photographs, all alike, and
/// writes their reports. What is up to date is not made again. A scene that fails does not stop the
/// others; only an interruption and a full disk do. Throws Error; E-WORKSPACE-BUSY where another
/// run builds a dataset in the folder.
[[nodiscard]] std::vector<SceneOutcome> run_dataset(const Dataset& dataset,
                                                    const std::filesystem::path& folder,
                                                    int threads, Progress& progress);

}  // namespace lumi
