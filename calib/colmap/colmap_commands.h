#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "calib/work/child_process.h"
#include "calib/work/progress.h"

namespace lumi {

/// COLMAP as it is run here, and what it left behind. Only these files know COLMAP 3.8's flags.
struct ColmapRun {
    std::string command_line;
    ChildResult result;
    std::string ending;  ///< "exit status 1", "signal 6 (Aborted)": for messages.
};

/// Where and how long COLMAP runs.
struct ColmapProgram {
    std::string program = "colmap";
    std::filesystem::path log_folder;  ///< One log a run, `NAME.log`.
    double time_limit_s = 3600;
};

/// What COLMAP's features are: its own settings.
struct ExtractorSettings {
    int max_features = 8192;  ///< Of each photograph.
    /// Least difference of Gaussians, grey values in [0, 1].
    double peak_threshold = 0.02 / 3;
};

/// When COLMAP's incremental mapper dares to start and to add a photograph.
struct MapperSettings {
    double init_min_triangulation_angle_deg = 16;
    int init_min_inliers = 100;
    int add_min_inliers = 30;
    double add_min_inlier_share = 0.25;
    bool refine_lens = true;
};

/// Makes an empty database at `database`.
[[nodiscard]] ColmapRun create_colmap_database(const ColmapProgram& program,
                                               const std::filesystem::path& database,
                                               const Progress& progress);

/// COLMAP's own features of the photographs in `pictures` that `database` names; where `masks` is
/// not empty, of what the mask NAME.png shows white.
[[nodiscard]] ColmapRun extract_features_with_colmap(const ColmapProgram& program,
                                                     const std::filesystem::path& database,
                                                     const std::filesystem::path& pictures,
                                                     const std::filesystem::path& masks,
                                                     const ExtractorSettings& settings, int threads,
                                                     const std::function<void(int)>& on_photographs,
                                                     const Progress& progress);

/// COLMAP's own matches and their geometric verification, all photographs with all.
[[nodiscard]] ColmapRun match_with_colmap(const ColmapProgram& program,
                                          const std::filesystem::path& database, int threads,
                                          const Progress& progress);

/// Places the photographs; models are written to `models/0`, `models/1`, ... `on_photographs` is
/// called with how many more photographs were placed.
[[nodiscard]] ColmapRun map_with_colmap(const ColmapProgram& program,
                                        const std::filesystem::path& database,
                                        const std::filesystem::path& models,
                                        const MapperSettings& settings, const std::string& log_name,
                                        const std::function<void(int)>& on_photographs,
                                        const Progress& progress);

/// The same with all of COLMAP's own settings, but for whether the lens may change: for comparison.
[[nodiscard]] ColmapRun map_with_colmap_defaults(const ColmapProgram& program,
                                                 const std::filesystem::path& database,
                                                 const std::filesystem::path& models,
                                                 bool refine_lens, int threads,
                                                 const std::function<void(int)>& on_photographs,
                                                 const Progress& progress);

}  // namespace lumi
