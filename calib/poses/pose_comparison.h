#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "calib/capture/rigid3.h"
#include "calib/poses/similarity_fit.h"

namespace lumi {

/// Poses by photograph name, wherever they come from.
using NamedPoses = std::map<std::string, Rigid3>;

/// Reads a COLMAP model folder, or a folder of Strecha `NAME.camera` files. Throws Error.
[[nodiscard]] NamedPoses read_named_poses(const std::filesystem::path& folder);

struct PoseDifference {
    std::string name;
    double position = 0.0;  ///< In the units of B.
    double rotation_deg = 0.0;
};

struct PoseComparison {
    Similarity3 b_from_a;
    std::vector<PoseDifference> views;  ///< Those that both have, sorted by name.
    double median_position = 0.0;
    double mean_position = 0.0;
    double max_position = 0.0;
    double median_rotation_deg = 0.0;
    double max_rotation_deg = 0.0;
};

/// How far poses A are from poses B after the similarity that fits A's centres onto B's
/// (fit_centres). Views are matched by name, however much of it each has kept (matched_names).
/// Throws Error (E-COMPARE-FEW) when fewer than three views match.
[[nodiscard]] PoseComparison compare_poses(const NamedPoses& a, const NamedPoses& b);

}  // namespace lumi
