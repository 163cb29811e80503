#include "calib/colmap/colmap_commands.h"

#include <algorithm>
#include <string_view>

#include "calib/work/formatted.h"

namespace lumi {
namespace {

/// A mapper that prints nothing for this long is spinning: it was seen to try starting pairs
/// without end.
constexpr double kMapperSilenceLimit_s = 300;

ColmapRun run(const ColmapProgram& program, std::vector<std::string> arguments,
              const std::string& log_name, double silence_limit_s,
              std::function<void(std::string_view)> on_output, const Progress& progress) {
    ChildCommand command;
    command.arguments.push_back(program.program);
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    // Otherwise COLMAP leaves log files in the system's temporary folder.
    command.arguments.insert(command.arguments.end(), {"--log_to_stderr", "1"});
    command.log_path = program.log_folder / (log_name + ".log");
    command.time_limit_s = program.time_limit_s;
    command.silence_limit_s = silence_limit_s;
    command.missing_advice =
        "install COLMAP 3.8 (Debian: apt-get install colmap), or name the program in [poses] "
        "colmap";
    command.on_output = std::move(on_output);
    ColmapRun result;
    result.command_line = command_line_of(command.arguments);
    result.result = run_child(command, progress);
    result.ending = description_of(result.result, command);
    return result;
}

/// Counts how often `mark` occurs in a stream that arrives in pieces.
std::function<void(std::string_view)> counter_of(std::string mark,
                                                 std::function<void(int)> on_count) {
    return [mark = std::move(mark), on_count = std::move(on_count),
            rest = std::string()](std::string_view text) mutable {
        rest += text;
        int count = 0;
        std::size_t end = 0;
        for (std::size_t at = rest.find(mark); at != std::string::npos; at = rest.find(mark, end)) {
            ++count;
            end = at + mark.size();
        }
        rest.erase(0, std::max(end, rest.size() - std::min(rest.size(), mark.size() - 1)));
        if (count > 0 && on_count) on_count(count);
    };
}

std::string flag(bool value) { return value ? "1" : "0"; }

}  // namespace

ColmapRun create_colmap_database(const ColmapProgram& program,
                                 const std::filesystem::path& database, const Progress& progress) {
    return run(program, {"database_creator", "--database_path", database.string()},
               "database_creator", 0, {}, progress);
}

ColmapRun extract_features_with_colmap(const ColmapProgram& program,
                                       const std::filesystem::path& database,
                                       const std::filesystem::path& pictures,
                                       const std::filesystem::path& masks,
                                       const ExtractorSettings& settings, int threads,
                                       const std::function<void(int)>& on_photographs,
                                       const Progress& progress) {
    std::vector<std::string> arguments{"feature_extractor",
                                       "--database_path",
                                       database.string(),
                                       "--image_path",
                                       pictures.string(),
                                       "--SiftExtraction.use_gpu",
                                       "0",
                                       "--SiftExtraction.num_threads",
                                       std::to_string(threads),
                                       "--SiftExtraction.max_num_features",
                                       std::to_string(settings.max_features),
                                       "--SiftExtraction.peak_threshold",
                                       formatted("%.17g", settings.peak_threshold)};
    if (!masks.empty()) {
        arguments.insert(arguments.end(), {"--ImageReader.mask_path", masks.string()});
    }
    return run(program, arguments, "feature_extractor", 0,
               counter_of("Processed file", on_photographs), progress);
}

ColmapRun match_with_colmap(const ColmapProgram& program, const std::filesystem::path& database,
                            int threads, const Progress& progress) {
    return run(
        program,
        {"exhaustive_matcher", "--database_path", database.string(), "--SiftMatching.use_gpu", "0",
         "--SiftMatching.num_threads", std::to_string(threads)},
        "exhaustive_matcher", 0, {}, progress);
}

ColmapRun map_with_colmap(const ColmapProgram& program, const std::filesystem::path& database,
                          const std::filesystem::path& models, const MapperSettings& settings,
                          const std::string& log_name,
                          const std::function<void(int)>& on_photographs,
                          const Progress& progress) {
    const std::string refine = flag(settings.refine_lens);
    return run(
        program,
        {"mapper", "--database_path", database.string(),
         // Required, but no picture is read: colours are taken by ourselves.
         "--image_path", models.string(), "--output_path", models.string(),
         "--Mapper.extract_colors", "0",
         // With more threads the sums, and so the poses, would depend on their number.
         "--Mapper.num_threads", "1", "--Mapper.max_num_models", "10",
         "--Mapper.init_min_tri_angle", std::to_string(settings.init_min_triangulation_angle_deg),
         "--Mapper.init_min_num_inliers", std::to_string(settings.init_min_inliers),
         "--Mapper.abs_pose_min_num_inliers", std::to_string(settings.add_min_inliers),
         "--Mapper.abs_pose_min_inlier_ratio", std::to_string(settings.add_min_inlier_share),
         "--Mapper.ba_refine_focal_length", refine, "--Mapper.ba_refine_extra_params", refine,
         // COLMAP's own settings for video: the same cameras, found faster.
         "--Mapper.ba_global_images_ratio", "1.4", "--Mapper.ba_global_points_ratio", "1.4",
         "--Mapper.ba_global_max_refinements", "2"},
        log_name, kMapperSilenceLimit_s, counter_of("Registering image #", on_photographs),
        progress);
}

ColmapRun map_with_colmap_defaults(const ColmapProgram& program,
                                   const std::filesystem::path& database,
                                   const std::filesystem::path& models, bool refine_lens,
                                   int threads, const std::function<void(int)>& on_photographs,
                                   const Progress& progress) {
    const std::string refine = flag(refine_lens);
    return run(program,
               {"mapper", "--database_path", database.string(), "--image_path", models.string(),
                "--output_path", models.string(), "--Mapper.extract_colors", "0",
                "--Mapper.num_threads", std::to_string(threads), "--Mapper.ba_refine_focal_length",
                refine, "--Mapper.ba_refine_extra_params", refine},
               "mapper_defaults", kMapperSilenceLimit_s,
               counter_of("Registering image #", on_photographs), progress);
}

}  // namespace lumi
