#include "pipeline/chart/growth.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/ingest/photograph_folder.h"
#include "calib/work/child_process.h"
#include "calib/work/counted.h"
#include "calib/work/error_of_exception.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "pipeline/line/line.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::vector<int> read_counts(const ConfigSection& section, const std::string& key) {
    std::vector<int> counts;
    for (const double number : section.numbers(key, {})) {
        if (number < 1.0 || number != std::floor(number) || number > 1e6) {
            section.refuse(key, "whole numbers above 0");
        }
        counts.push_back(static_cast<int>(number));
    }
    return counts;
}

/// What stands in a folder that an earlier run made; where anything else does, all is left.
void remove_links(const fs::path& folder) {
    std::error_code status;
    std::vector<fs::path> links;
    for (const auto& entry : fs::directory_iterator(folder, status)) {
        if (!entry.is_symlink()) refuse_loss(entry.path(), "would be lost");
        links.push_back(entry.path());
    }
    for (const fs::path& link : links) fs::remove(link);
}

/// In order of name, sub-folders aside.
std::vector<fs::path> photographs_in(const fs::path& folder) {
    std::error_code status;
    if (!fs::is_directory(folder, status)) {
        throw Error(ErrorKind::kUsage, "E-GROWTH-PHOTOS",
                    folder.string() + ": growth is measured on a folder of photographs",
                    "set photos, not video, under [capture]");
    }
    std::vector<fs::path> files;
    for (const PhotographFile& file : list_photographs(folder, {}, {}).files) {
        if (file.name.find('/') == std::string::npos) files.push_back(file.path);
    }
    return files;
}

double mean_megapixels(const fs::path& ingest_folder) {
    const std::vector<Photograph> photographs = read_photograph_list(ingest_folder).photographs;
    double pixels = 0.0;
    for (const Photograph& one : photographs) {
        pixels += static_cast<double>(one.width_px) * one.height_px;
    }
    return pixels / 1e6 / std::max(1.0, static_cast<double>(photographs.size()));
}

class GrowthRun {
 public:
    GrowthRun(const ConfigDocument& document, const fs::path& program, const fs::path& folder,
              int threads, Progress& progress)
        : document_(document),
          config_(document.build_config_with({})),
          program_(program),
          folder_(fs::absolute(folder)),
          threads_(threads),
          progress_(progress) {}

    GrowthResult measure(const GrowthPlan& plan) {
        GrowthResult result;
        for (const int count : plan.photographs) {
            const std::string name = counted(count, "photograph");
            attempt(name, result, [&] {
                const std::string photos = literal_of_text(first_photographs(count).string());
                append(result.by_photographs, sample("photographs-" + std::to_string(count),
                                                     {{"capture.photos", photos}}));
            });
        }
        for (const int width_px : plan.widths_px) {
            const std::string name = "photographs of " + std::to_string(width_px) + " pixels";
            attempt(name, result, [&] {
                append(result.by_size,
                       sample("width-" + std::to_string(width_px),
                              {{"capture.max_width_px", std::to_string(width_px)}}));
            });
        }
        const bool is_empty = result.by_photographs.empty() && result.by_size.empty();
        if (is_empty && first_error_) throw *first_error_;
        return result;
    }

 private:
    static void append(std::vector<GrowthSample>& samples, std::vector<GrowthSample> more) {
        samples.insert(samples.end(), more.begin(), more.end());
    }

    template <class Work>
    void attempt(const std::string& name, GrowthResult& result, const Work& work) {
        progress_.note("growth: " + name);
        try {
            work();
        } catch (const std::exception& exception) {
            const std::optional<Error> error = error_of_exception(exception);
            if (!error || ends_all_work(*error)) throw;
            result.failures.push_back(name + ": " + failure_text(*error));
            progress_.note(result.failures.back());
            first_error_ = first_error_.value_or(*error);
        }
    }

    /// A folder with links to the first `count` photographs.
    [[nodiscard]] fs::path first_photographs(int count) const {
        const std::vector<fs::path> files = photographs_in(config_.photographs_or_video);
        const fs::path folder = folder_ / ("photos-" + std::to_string(count));
        remove_links(folder);
        fs::create_directories(folder);
        for (std::size_t i = 0; i < files.size() && i < static_cast<std::size_t>(count); ++i) {
            fs::create_symlink(fs::absolute(files[i]), folder / files[i].filename());
        }
        return folder;
    }

    /// Of the configuration with changes, which is written to another folder than its own.
    std::vector<GrowthSample> sample(const std::string& name,
                                     const std::vector<ConfigChange>& changes) {
        const fs::path config_path = folder_ / (name + ".toml");
        write_whole_text(config_path, document_.build_config_with(changes).movable_toml);
        const WorkspaceLayout workspace(folder_ / name, config_.name);
        std::vector<GrowthSample> samples;
        for (const std::string& stage : stages_of_line()) {
            run_stage(stage, config_path, workspace);
            samples.push_back(sample_of(stage, workspace));
        }
        return samples;
    }

    void run_stage(const std::string& stage, const fs::path& config_path,
                   const WorkspaceLayout& workspace) const {
        ChildCommand command;
        command.arguments = {program_.string(),
                             "--quiet",
                             stage,
                             config_path.string(),
                             "--workspace",
                             workspace.folder().string(),
                             "--threads",
                             std::to_string(threads_)};
        command.log_path = folder_ / "log.txt";
        command.time_limit_s = 24.0 * 3600.0;
        const ChildResult result = run_child(command, progress_);
        if (result.end == ChildEnd::kExited && result.exit_status == 0) return;
        throw Error(ErrorKind::kExternalProgram, "E-GROWTH-STAGE",
                    "the stage " + stage + " failed (" + description_of(result, command) +
                        "): " + read_whole_text(command.log_path),
                    "run it by itself: " + command_line_of(command.arguments));
    }

    /// The stage's cost when it was run, which may have been earlier.
    static GrowthSample sample_of(const std::string& stage, const WorkspaceLayout& workspace) {
        const Json stages = read_json_file(workspace.stages_path());
        GrowthSample sample;
        sample.stage = stage;
        const auto list = read_photograph_list(workspace.stage_folder("ingest"));
        sample.photographs = static_cast<int>(list.photographs.size());
        sample.megapixels = mean_megapixels(workspace.stage_folder("ingest"));
        for (const Json& entry : stages.at("stages")) {
            if (entry.at("name") != stage) continue;
            sample.cpu_s = entry.at("cpu_s");
            sample.wall_s = entry.at("wall_s");
            sample.peak_mib = entry.at("peak_mib");
        }
        return sample;
    }

    const ConfigDocument& document_;
    BuildConfig config_;
    fs::path program_;
    fs::path folder_;
    int threads_;
    Progress& progress_;
    std::optional<Error> first_error_;
};

}  // namespace

GrowthPlan read_growth_plan(const ConfigDocument& document) {
    const ConfigSection section = document.options_of("growth");
    const GrowthPlan plan{read_counts(section, "photographs"),
                          read_counts(section, "max_width_px")};
    section.expect_all_keys_known();
    return plan;
}

GrowthResult measure_growth(const ConfigDocument& document, const GrowthPlan& plan,
                            const fs::path& program, const fs::path& folder, int threads,
                            Progress& progress) {
    fs::create_directories(folder);
    return GrowthRun(document, program, folder, threads, progress).measure(plan);
}

}  // namespace lumi
