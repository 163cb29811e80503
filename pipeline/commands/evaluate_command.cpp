#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/printable.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/config/config_variant.h"
#include "pipeline/evaluate/evaluate_workspace.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/evaluate/free_form_comparison.h"
#include "pipeline/evaluate/metric_words.h"
#include "pipeline/line/code_version.h"
#include "pipeline/line/line.h"
#include "pipeline/protocol/leave_one_out.h"
#include "pipeline/report/workspace_report.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

struct EvaluateRequest {
    std::filesystem::path workspace;
    std::vector<std::string> modes{"perpixel", "lightfield"};
    bool without_ghost_energy = false;
    bool leave_one_out = false;
    bool keep_depth = false;
    bool as_taken = false;
    bool rivals = false;
};

std::string score_line(const std::string& mode, const ViewScore& score) {
    const std::string covered =
        score.psnr_covered_db ? number_text(*score.psnr_covered_db, 2) : std::string("none");
    const auto but_for_exposure =
        psnr_but_for_exposure_db(score.psnr_covered_db, score.psnr_gain_fitted_db);
    const std::string exposure =
        but_for_exposure ? ", " + number_text(*but_for_exposure, 2) + " dB but for exposure"
                         : std::string();
    const std::string subject =
        score.psnr_subject_db
            ? "  subject " + number_text(*score.psnr_subject_db, 2) + " dB at " +
                  number_text(100.0 * score.subject_coverage.value_or(0.0), 2) + " %"
            : std::string();
    return mode + "  " + printable(score.name) + "  PSNR " + number_text(score.psnr_db, 2) +
           " dB  covered " + covered + " dB" + exposure + subject + "  SSIM " +
           number_text(score.ssim, 4) + "  FLIP " + number_text(score.flip, 4) + "  coverage " +
           number_text(100.0 * score.coverage, 2) + " %  " + number_text(score.ms, 1) +
           " ms  CPU " + number_text(score.cpu_ms, 1) + " ms\n";
}

/// How far the means can be trusted: by intervals, or by how far few views lie apart.
std::string certainty_text(const std::vector<ViewScore>& views) {
    std::string intervals;
    std::string ranges;
    for (const ScoreMetric& metric : score_metrics()) {
        const auto interval = interval_of(metric, views);
        const auto told = interval ? interval : range_of(metric, views);
        if (!told) continue;
        (interval ? intervals : ranges) += "  " + told_range(metric, *told);
    }
    std::string text;
    if (!intervals.empty()) text += "  95 % intervals of the means:" + intervals + "\n";
    if (!ranges.empty() && views.size() > 1)
        text += "  ranges over the views, too few for intervals:" + ranges + "\n";
    return text;
}

/// Which held-out photographs are no part of the means.
std::string not_judged_text(const Evaluation& evaluation) {
    const std::vector<std::string>& missing = evaluation.not_judged;
    if (missing.empty()) return {};
    const std::size_t judged = evaluation.modes.front().views.size();
    std::string text = std::to_string(judged) + " of " + std::to_string(judged + missing.size()) +
                       " held-out photographs judged; ";
    for (std::size_t i = 0; i < missing.size(); ++i)
        text += (i == 0 ? "" : ", ") + printable(missing[i]);
    return text + (missing.size() == 1 ? " has" : " have") + " no pose\n";
}

/// Every method on the same pixels.
std::string common_pixels_text(const CommonPixelScores& scores) {
    std::string text = "PSNR over the " + number_text(100.0 * scores.share, 2) +
                       " % of pixels that all methods cover that draw from the photographs' "
                       "depth:\n";
    for (const CommonPixelScores::Method& method : scores.methods)
        text += "  " + method.name + "  " +
                (method.psnr_db ? number_text(*method.psnr_db, 2) + " dB" : "none") + "\n";
    return text;
}

/// "+0.10 dB" or "-0.10 dB".
std::string gain_text(double gain_db) {
    return (gain_db < 0 ? "" : "+") + number_text(gain_db, 2) + " dB";
}

/// What free-form costs and brings beside regular parameterisations, in the same mode.
std::string free_form_text(const FreeFormBesideResampled& compared) {
    std::string text = name_of(compared.mode) + " beside " + compared.resampled + ": ";
    if (compared.cpu_ratio)
        text += number_text(*compared.cpu_ratio, 2) + " times its CPU time a frame, ";
    text += gain_text(compared.psnr_gain_db);
    if (compared.common_psnr_gain_db)
        text += " (" + gain_text(*compared.common_psnr_gain_db) +
                " over pixels that all methods cover)";
    return text + "\n";
}

void print_rivals(const RivalEvaluation& rivals, const CommandContext& context) {
    for (const RivalScores& scores : rivals.methods) {
        for (const ViewScore& view : scores.views)
            context.print_result(score_line(scores.method, view));
        context.print_result(score_line(scores.method, mean_score(scores.views)));
        if (scores.resampling_cpu_s > 0)
            context.print_result("  after resampling the photographs, " +
                                 number_text(scores.resampling_cpu_s, 1) + " CPU s\n");
    }
    for (const RivalLeftOut& rival : rivals.left_out)
        context.print_result("not drawn: " + rival.method + "; " + rival.reason + "\n");
    if (rivals.common) context.print_result(common_pixels_text(*rivals.common));
}

void print_scores(const Evaluation& evaluation, const CommandContext& context) {
    context.print_result(not_judged_text(evaluation));
    if (!evaluation.subject_from.empty()) {
        context.print_result("subject: told from the rest by " + evaluation.subject_from + '\n');
    }
    for (const ModeScores& scores : evaluation.modes) {
        const std::string mode = name_of(scores.mode);
        for (const ViewScore& view : scores.views) context.print_result(score_line(mode, view));
        context.print_result(score_line(mode, mean_score(scores.views)));
        context.print_result(certainty_text(scores.views));
        if (scores.ghost_between_blocks) {
            context.print_result("  ghost energy against the true error, rank correlation " +
                                 number_text(*scores.ghost_between_blocks, 2) + " over blocks\n");
        }
    }
    if (evaluation.rivals) print_rivals(*evaluation.rivals, context);
    for (const FreeFormBesideResampled& compared : free_form_beside_resampled(evaluation))
        context.print_result(free_form_text(compared));
}

std::vector<RenderMode> modes_of(const EvaluateRequest& request) {
    std::vector<RenderMode> modes;
    for (const std::string& name : request.modes) modes.push_back(render_mode_from(name));
    if (!request.rivals) return modes;
    // Beside rivals: what lumi draws as papers say, and the modes that resampled pictures are drawn
    // in.
    for (const RenderMode mode : {RenderMode::kAdaptive, RenderMode::kPaper2001, RenderMode::kHeigl,
                                  RenderMode::kLightField})
        if (std::find(modes.begin(), modes.end(), mode) == modes.end()) modes.push_back(mode);
    return modes;
}

Exposures chosen_exposures(const EvaluateRequest& request) {
    return request.as_taken ? Exposures::kAsTaken : Exposures::kEvened;
}

nlohmann::ordered_json leave_one_out_json(const LeaveOneOut& result) {
    const bool is_removed = !result.depth_removed.modes.empty();
    return {{"schema_version", kEvaluationSchemaVersion},
            {"protocol", "leave-one-out"},
            {"photographs", result.photographs},
            {"depth_kept", evaluation_json(result.depth_kept)},
            {"depth_removed",
             is_removed ? evaluation_json(result.depth_removed) : nlohmann::ordered_json()}};
}

/// Every photograph left out in turn; the request's workspace is a configuration.
void run_leave_one_out(const EvaluateRequest& request, const CommandContext& context) {
    const ConfigDocument document = ConfigDocument::open(request.workspace);
    const BuildConfig config = document.build_config_with({});
    const std::filesystem::path folder = workspace_of(config).folder().string() + "-leave-one-out";
    require_writable_folder(folder);
    const int threads = context.threads > 0 ? context.threads : config.threads;
    const LeaveOneOut result =
        leave_one_out(document, modes_of(request), chosen_exposures(request), !request.keep_depth,
                      folder, threads, *context.progress);
    nlohmann::ordered_json json = leave_one_out_json(result);
    json["exposures"] = name_of(chosen_exposures(request));
    write_json_file(folder / "leave-one-out.json", json);
    if (context.json) {
        context.print_result(json);
        return;
    }
    context.print_result(std::string("depth of the others found with each photograph\n"));
    print_scores(result.depth_kept, context);
    if (request.keep_depth) return;
    context.print_result(std::string("left out of depth, too\n"));
    print_scores(result.depth_removed, context);
}

void run_evaluate(const EvaluateRequest& request, const CommandContext& context) {
    EvaluationOptions options;
    options.ghost_energy = !request.without_ghost_energy;
    options.modes = modes_of(request);
    options.rivals = request.rivals;
    options.exposures = chosen_exposures(request);
    const Workspace workspace(find_workspace(request.workspace));
    const Evaluation evaluation = evaluate_workspace(
        workspace, options, code_version_of("evaluate"), context.threads, *context.progress);
    write_workspace_report(workspace);
    if (context.json) {
        context.print_result(evaluation_json(evaluation));
    } else {
        print_scores(evaluation, context);
    }
    context.say(workspace.report_path().string() + "\n");
}

}  // namespace

void add_evaluate_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "evaluate",
                    "Held-out photographs against renderings: dB, SSIM, FLIP, sharpness, "
                    "coverage, ms",
                    "lumi evaluate work/fountain\n"
                    "         lumi evaluate work/fountain --mode adaptive --rivals\n"
                    "         lumi evaluate configs/banana.toml --leave-one-out");
    const auto request = std::make_shared<EvaluateRequest>();
    command.add_option("WORKSPACE", request->workspace, "Folder that lumi build wrote")->required();
    command
        .add_option("--mode", request->modes,
                    "As in lumi render; also several, with commas between")
        ->allow_extra_args(false)
        ->delimiter(',')
        ->capture_default_str();
    CLI::Option* no_ghosts = command.add_flag("--no-ghost-energy", request->without_ghost_energy,
                                              "Leave out what takes one renderer a camera class");
    command.add_flag("--as-taken", request->as_taken,
                     "Draw without evening exposure, white balance and dark corners out");
    CLI::Option* rivals = command.add_flag(
        "--rivals", request->rivals,
        "Also the methods that the paper is compared with: Heigl et al. 1999, unstructured "
        "lumigraph, view-dependent texture, forward warping, two-plane, spherical, and, without "
        "depth, dynamically reparameterized (`lumi render` draws them by --mode heigl and by "
        "--rival); beside them "
        "adaptive, paper2001 and lightfield; takes minutes");
    CLI::Option* leave_one_out =
        command.add_flag("--leave-one-out", request->leave_one_out,
                         "WORKSPACE is a configuration: every photograph is left out in turn, "
                         "without ghost energy");
    leave_one_out->excludes(rivals)->excludes(no_ghosts);
    command
        .add_flag("--keep-depth", request->keep_depth,
                  "With --leave-one-out: only where depth is not found anew")
        ->needs(leave_one_out);
    command.callback([request, &context] {
        context.chosen = [request, &context] {
            request->leave_one_out ? run_leave_one_out(*request, context)
                                   : run_evaluate(*request, context);
        };
    });
}

}  // namespace lumi
