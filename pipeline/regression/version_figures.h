#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calib/work/progress.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {

/// A figure of this version of lumi.
struct VersionFigure {
    double value = 0.0;
    double noise = 0.0;  ///< By how much it moves when nothing has changed.
    bool higher_is_better = false;
};

/// By name: "error.perpixel.flip", "ratio.perpixel".
using VersionFigures = std::map<std::string, VersionFigure>;

/// Errors of a finished workspace on its held-out photographs in every mode, and frame times as a
/// ratio to a blend of three textures, the median of `rounds` measurements; their noise is half of
/// what these differ by, and 5 %. Errors are exact on one machine; the noise allows for another
/// OpenGL. Throws Error (E-EVAL-..., E-GL-...).
[[nodiscard]] VersionFigures measure_version(const WorkspaceLayout& workspace, int frames,
                                             int rounds, int threads, Progress& progress);

[[nodiscard]] nlohmann::ordered_json version_figures_json(const VersionFigures& figures);
/// Throws Error (E-JSON-READ).
[[nodiscard]] VersionFigures read_version_figures(const std::filesystem::path& path);

/// A figure that moved.
struct FigureMove {
    std::string name;
    double before = 0.0;
    double now = 0.0;
    double noise = 0.0;  ///< Of both together.
    bool is_better = false;
};

/// Two versions side by side.
struct FigureComparison {
    std::size_t compared = 0;       ///< Figures that both have.
    std::vector<FigureMove> moves;  ///< Of these, beyond the noise of both.
    std::vector<std::string> only_before;
    std::vector<std::string> only_now;
};

[[nodiscard]] FigureComparison compare_figures(const VersionFigures& before,
                                               const VersionFigures& now);

/// Throws Error, of kind kPartialResult: E-REGRESSION-WORSE (a figure is worse),
/// E-REGRESSION-MISSING (a figure of the baseline is not there to compare, or none is).
void refuse_regression(const FigureComparison& comparison, const std::filesystem::path& baseline);

}  // namespace lumi
