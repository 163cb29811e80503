#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calib/poses/pose_comparison.h"
#include "calib/poses/pose_stage.h"
#include "calib/work/stopwatch.h"

namespace lumi {

/// One way from photographs to poses.
struct PoseMeans {
    PoseProgram front_end = PoseProgram::kLumi;
    PoseProgram mapper = PoseProgram::kLumi;
    bool is_colmap_alone = false;  ///< COLMAP with its defaults, and nothing of ours.
    int max_features = 4096;
    int max_width_px = 1600;          ///< Of the working copies.
    std::string lens_model = "auto";  ///< As in PoseOptions; tells nothing where a lens is given.

    friend bool operator==(const PoseMeans&, const PoseMeans&) = default;
};
[[nodiscard]] std::string name_of(const PoseMeans& means);

/// What came of it.
struct PoseTrial {
    PoseMeans means;
    Cost cost;  ///< From working copies to poses.
    int photographs = 0;
    int placed = 0;
    int points = 0;
    std::string lens;     ///< Form of the first lens, as it came out; empty for COLMAP alone.
    double focal_px = 0;  ///< Of that lens; 0 without poses.
    std::optional<PoseComparison> difference;  ///< From the truth, where that is known.
    std::string refusal;                       ///< Code of the error, when there were no poses.
};

/// What all trials have in common.
struct PoseTrialSetting {
    std::filesystem::path photographs;
    IngestOptions ingest;  ///< Of any width.
    std::optional<Camera> given_lens;
    PoseOptions options;
    NamedPoses truth;  ///< Empty: not known.
    /// Where each trial has a folder for what is needed on the way, which goes with it.
    std::filesystem::path scratch_folder;
    int threads = 0;
};

/// Finds poses by these means and measures. A refusal is a result; throws Error only for what has
/// nothing to do with the poses (E-INGEST-..., E-CHILD-..., E-INTERRUPTED).
[[nodiscard]] PoseTrial try_poses(const PoseTrialSetting& setting, const PoseMeans& means,
                                  Progress& progress);

/// CPU seconds that comparing two random photographs of so many features takes, both directions,
/// for each instruction set of this machine; the best of some runs, on one thread.
struct MatchingCost {
    std::string instructions;
    double cpu_s = 0;
};
[[nodiscard]] std::vector<MatchingCost> time_matching(int features, const Progress& progress);

}  // namespace lumi
