#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "pipeline/commands/commands.h"
#include "pipeline/commands/render_mode_argument.h"
#include "pipeline/evaluate/evaluate_workspace.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/report/number_text.h"
#include "pipeline/report/workspace_report.h"

namespace lumi {
namespace {

std::string score_line(const std::string& mode, const ViewScore& score) {
    const std::string covered =
        score.psnr_covered_db ? number_text(*score.psnr_covered_db, 2) : std::string("none");
    return mode + "  " + score.name + "  PSNR " + number_text(score.psnr_db, 2) + " dB  covered " +
           covered + " dB  SSIM " + number_text(score.ssim, 4) + "  coverage " +
           number_text(100.0 * score.coverage, 2) + " %  " + number_text(score.ms, 1) + " ms\n";
}

void print_scores(const Evaluation& evaluation, const CommandContext& context) {
    for (const ModeScores& scores : evaluation.modes) {
        const std::string mode = name_of(scores.mode);
        for (const ViewScore& view : scores.views) context.print_result(score_line(mode, view));
        context.print_result(score_line(mode, mean_score(scores.views)));
    }
}

void run_evaluate(const std::filesystem::path& folder, const std::vector<std::string>& mode_names,
                  const CommandContext& context) {
    std::vector<RenderMode> modes;
    for (const std::string& name : mode_names) modes.push_back(render_mode_from(name));
    const Workspace workspace(find_workspace(folder));
    const Evaluation evaluation =
        evaluate_workspace(workspace, modes, context.threads, *context.progress);
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
    CLI::App& command = add_command(
        app, "evaluate", "Held-out photographs against renderings: dB, SSIM, coverage, ms",
        "lumi evaluate work/fountain");
    const auto folder = std::make_shared<std::filesystem::path>();
    const auto modes = std::make_shared<std::vector<std::string>>(
        std::vector<std::string>{"perpixel", "lightfield"});
    command.add_option("WORKSPACE", *folder, "Folder that lumi build wrote")->required();
    command.add_option("--mode", *modes, "perpixel, lightfield; may be repeated")
        ->allow_extra_args(false)
        ->capture_default_str();
    command.callback([folder, modes, &context] {
        context.chosen = [folder, modes, &context] { run_evaluate(*folder, *modes, context); };
    });
}

}  // namespace lumi
