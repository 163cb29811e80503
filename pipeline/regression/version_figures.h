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

/// What figures are of: those of other photographs say nothing of a version.
struct MeasuredScene {
    std::string name;  ///< Of the package.
    int width_px = 0;  ///< The most of the held-out photographs.
    int height_px = 0;
    std::vector<std::string> views;  ///< The held-out photographs.
    friend bool operator==(const MeasuredScene&, const MeasuredScene&) = default;
};

/// Figures of a version, what they are of, and how frames were timed.
struct MeasuredVersion {
    MeasuredScene scene;
    int frames = 0;  ///< Along a path from view to view.
    int rounds = 0;
    VersionFigures figures;
};

/// What measure_version would measure. Throws Error (E-EVAL-...).
[[nodiscard]] MeasuredScene scene_to_measure(const WorkspaceLayout& workspace, int threads);

/// Errors of a finished workspace on its held-out photographs in every mode, and frame times as a
/// ratio to a blend of three textures, the median of `rounds` measurements; their noise is half of
/// what these differ by, and 5 %. Errors are exact on one machine; the noise allows for another
/// OpenGL. Throws Error (E-EVAL-..., E-GL-...).
[[nodiscard]] MeasuredVersion measure_version(const WorkspaceLayout& workspace, int frames,
                                              int rounds, int threads, Progress& progress);

[[nodiscard]] nlohmann::ordered_json version_json(const MeasuredVersion& version);
/// Throws Error (E-JSON-READ; E-REGRESSION-OTHER where the file does not say what it is of).
[[nodiscard]] MeasuredVersion read_version(const std::filesystem::path& path);

/// Throws Error (E-REGRESSION-OTHER) unless the frames of a baseline were timed as often, along as
/// long a path.
void expect_same_timing(const MeasuredVersion& before, int frames, int rounds,
                        const std::filesystem::path& baseline);

/// Throws Error (E-REGRESSION-OTHER) unless a baseline is of the same scene.
void expect_same_scene(const MeasuredScene& before, const MeasuredScene& now,
                       const std::filesystem::path& baseline);

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
