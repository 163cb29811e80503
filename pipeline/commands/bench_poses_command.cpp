#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/config/build_config.h"
#include "pipeline/pose_bench/pose_chart.h"
#include "pipeline/pose_bench/pose_trial.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int kMatchedFeatures = 8192;

struct BenchPosesRequest {
    fs::path config;
    fs::path truth;
    fs::path chart_folder;
    fs::path scratch_folder = "work/bench-poses";
    bool with_colmap = true;
};

Json trial_json(const PoseTrial& trial) {
    Json json{{"means", name_of(trial.means)},
              {"max_features", trial.means.max_features},
              {"max_width_px", trial.means.max_width_px},
              {"lens_model", trial.means.lens_model},
              {"cpu_s", trial.cost.cpu_s},
              {"wall_s", trial.cost.wall_s},
              {"photographs", trial.photographs},
              {"placed", trial.placed},
              {"points", trial.points},
              {"lens", trial.lens},
              {"focal_px", trial.focal_px}};
    if (trial.difference) {
        json["position_error"] = {{"median", trial.difference->median_position},
                                  {"mean", trial.difference->mean_position},
                                  {"max", trial.difference->max_position}};
        json["rotation_error_deg"] = {{"median", trial.difference->median_rotation_deg},
                                      {"max", trial.difference->max_rotation_deg}};
    }
    if (!trial.refusal.empty()) json["refusal"] = trial.refusal;
    return json;
}

std::string trial_text(const PoseTrial& trial) {
    std::string text = name_of(trial.means) + ", " + std::to_string(trial.means.max_features) +
                       " features at " + std::to_string(trial.means.max_width_px) +
                       " px: " + number_text(trial.cost.cpu_s, 2) + " CPU s, " +
                       number_text(trial.cost.wall_s, 1) + " s, " + std::to_string(trial.placed) +
                       " of " + std::to_string(trial.photographs) + " placed";
    if (!trial.refusal.empty()) text += ", refused: " + trial.refusal;
    if (trial.difference) {
        text += ", position error median " + number_text(trial.difference->median_position, 5) +
                " mean " + number_text(trial.difference->mean_position, 5);
    }
    if (!trial.lens.empty()) {
        text += ", " + trial.lens + ", focal length " + number_text(trial.focal_px, 1) + " px";
    }
    return text + "\n";
}

/// Everything that was measured in one run.
struct BenchPosesReport {
    std::vector<MatchingCost> matching;
    std::vector<PoseTrial> trials;  ///< As configured; then COLMAP alone; then the chart's.
};

double colmap_ratio(const BenchPosesReport& report) {
    return report.trials[0].cost.cpu_s / report.trials[1].cost.cpu_s;
}

Json report_json(const BenchPosesReport& report, bool with_colmap) {
    Json matching = Json::object();
    for (const MatchingCost& cost : report.matching) matching[cost.instructions] = cost.cpu_s;
    Json trials = Json::array();
    for (const PoseTrial& trial : report.trials) trials.push_back(trial_json(trial));
    Json json{{"matching_8192_both_ways_cpu_s", std::move(matching)}};
    if (with_colmap) json["cpu_ratio_to_colmap"] = colmap_ratio(report);
    json["trials"] = std::move(trials);
    return json;
}

std::string report_text(const BenchPosesReport& report, bool with_colmap) {
    std::string text;
    for (const MatchingCost& cost : report.matching) {
        text += "matching 8192 with 8192 descriptors, both ways, " + cost.instructions + ": " +
                number_text(cost.cpu_s, 4) + " CPU s\n";
    }
    for (const PoseTrial& trial : report.trials) text += trial_text(trial);
    if (with_colmap) {
        text += "CPU seconds, as a ratio to COLMAP alone: " + number_text(colmap_ratio(report), 3) +
                "\n";
    }
    return text;
}

void write_chart(const BenchPosesRequest& request, const BenchPosesReport& report,
                 const std::string& title, const Progress& progress) {
    const fs::path& folder = request.chart_folder;
    write_whole_text(folder / "poses.csv", trials_csv(report.trials));
    write_json_file(folder / "poses.json", report_json(report, request.with_colmap));
    draw_pose_chart(report.trials, title, folder / "poses.svg", progress);
}

void run_bench_poses(const BenchPosesRequest& request, const CommandContext& context) {
    if (!request.chart_folder.empty()) require_writable_folder(request.chart_folder);
    const BuildConfig config = load_build_config(request.config);
    PoseTrialSetting setting{config.photographs_or_video,
                             config.ingest,
                             config.given_lens,
                             config.poses,
                             {},
                             request.scratch_folder,
                             context.threads > 0 ? context.threads : config.threads};
    if (!request.truth.empty()) setting.truth = read_named_poses(request.truth);
    const int width_px = config.ingest.max_width_px;
    const PoseOptions& poses = config.poses;
    std::vector<PoseMeans> means{
        {poses.front_end, poses.mapper, false, poses.max_features, width_px, poses.lens_model}};
    if (request.with_colmap) {
        means.push_back(
            {PoseProgram::kColmap, PoseProgram::kColmap, true, 8192, width_px, poses.lens_model});
    }
    if (!request.chart_folder.empty()) {
        for (PoseMeans& one : chart_means(width_px)) {
            if (one != means.front()) means.push_back(std::move(one));
        }
    }
    BenchPosesReport report{time_matching(kMatchedFeatures, *context.progress), {}};
    const std::size_t beside = request.with_colmap ? 1 : 0;
    for (const PoseMeans& one : means) {
        report.trials.push_back(try_poses(setting, one, *context.progress));
        const std::size_t done = report.trials.size();
        context.say(std::to_string(done) + " of " + std::to_string(means.size()) + ": " +
                    trial_text(report.trials.back()));
        // After each, so that whoever stops a long run has a chart of what was measured.
        if (!request.chart_folder.empty() && done > beside) {
            write_chart(request, report, "From photographs to poses: " + config.name,
                        *context.progress);
        }
    }
    if (context.json) {
        context.print_result(report_json(report, request.with_colmap));
    } else {
        context.print_result(report_text(report, request.with_colmap));
    }
}

}  // namespace

void add_bench_poses_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "bench-poses",
        "Time and accuracy from photographs to poses, beside COLMAP alone on the same photographs",
        "lumi bench-poses configs/fountain-given-lens.toml --truth fountain-P11/cameras");
    const auto request = std::make_shared<BenchPosesRequest>();
    command
        .add_option("CONFIG", request->config, "Configuration, a folder of photographs, or a video")
        ->required();
    command.add_option("--truth", request->truth,
                       "Folder with a COLMAP model or with .camera files to measure against");
    command.add_option("--chart", request->chart_folder,
                       "Also try features by size by front end by mapper, and write poses.svg, "
                       "poses.json and poses.csv here");
    command
        .add_option("--scratch", request->scratch_folder, "Folder for what is needed on the way")
        ->capture_default_str();
    command.add_flag("!--without-colmap", request->with_colmap, "Leave COLMAP alone out");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench_poses(*request, context); };
    });
}

}  // namespace lumi
