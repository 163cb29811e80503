#include "pipeline/dataset/run_dataset.h"

#include <nlohmann/json.hpp>

#include "calib/work/error_of_exception.h"
#include "pipeline/evaluate/evaluate_workspace.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/line/chosen_workspace.h"
#include "pipeline/line/code_version.h"
#include "pipeline/line/line.h"
#include "pipeline/line/placed_photographs.h"
#include "pipeline/report/workspace_report.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/workspace/folder_lock.h"
#include "pipeline/workspace/folder_size.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The first mode's scores in the workspace; none when they were made with other options or code.
std::optional<ModeScores> kept_scores(const Workspace& workspace, const EvaluationOptions& options,
                                      const std::string& code_version) {
    const Json evaluation = read_current_evaluation(workspace);
    if (evaluation.is_null() ||
        evaluation.value("made_with", Json()) != made_with_json(options, code_version)) {
        return std::nullopt;
    }
    try {
        return mode_scores_from(options.modes.front(), evaluation);
    } catch (const Json::exception&) {
        return std::nullopt;  // Damaged.
    }
}

/// The first mode's scores of the package that stands in the workspace, measured if need be: those
/// of all scenes are compared, and must have been made alike.
ModeScores current_scores(const Workspace& workspace, int threads, Progress& progress) {
    const EvaluationOptions options;
    const std::string code_version = code_version_of("evaluate");
    if (auto kept = kept_scores(workspace, options, code_version)) return *kept;
    return evaluate_workspace(workspace, options, code_version, threads, progress).modes.front();
}

std::optional<Interval> flip_interval_of(const std::vector<ViewScore>& views) {
    for (const ScoreMetric& metric : score_metrics()) {
        if (std::string("flip") == metric.name) return interval_of(metric, views);
    }
    return std::nullopt;
}

void build(const DatasetScene& scene, const fs::path& folder, int threads, SceneOutcome& outcome,
           Progress& progress) {
    const int scene_threads = threads > 0 ? threads : scene.config.threads;
    const Workspace workspace(layout_for(folder / scene.name, scene.config, scene_threads));
    work_and_report(workspace, [&] {
        const std::vector<FinishedStage> stages =
            run_line(scene.config, workspace, "pack", scene_threads, progress);
        for (const FinishedStage& stage : stages) {
            outcome.cpu_s += stage.cost.cpu_s;
            outcome.wall_s += stage.cost.wall_s;
        }
        outcome.photographs = placed_photographs(stages).value_or(PlacedPhotographs{});
        outcome.package_mib = folder_mib(workspace.package_folder());
        if (read_pack_record(workspace.stage_folder("pack")).held_out.empty()) return;
        const ModeScores scores = current_scores(workspace, scene_threads, progress);
        outcome.mean = mean_score(scores.views);
        outcome.flip_interval = flip_interval_of(scores.views);
    });
}

}  // namespace

std::vector<SceneOutcome> run_dataset(const Dataset& dataset, const fs::path& folder, int threads,
                                      Progress& progress) {
    const FolderLock lock(folder);
    std::vector<SceneOutcome> outcomes;
    for (const DatasetScene& scene : dataset.scenes) {
        progress.note("scene " + std::to_string(outcomes.size() + 1) + " of " +
                      std::to_string(dataset.scenes.size()) + ": " + scene.name);
        SceneOutcome outcome;
        outcome.name = scene.name;
        outcome.failure = scene.failure;
        if (!outcome.failure) {
            try {
                build(scene, folder, threads, outcome, progress);
            } catch (const std::exception& exception) {
                outcome.failure = error_of_exception(exception);
                if (!outcome.failure || ends_all_work(*outcome.failure)) throw;
                progress.note(scene.name + ": " + failure_text(*outcome.failure));
            }
        }
        outcomes.push_back(std::move(outcome));
    }
    return outcomes;
}

}  // namespace lumi
