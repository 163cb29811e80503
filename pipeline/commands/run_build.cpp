#include "pipeline/commands/run_build.h"

#include <nlohmann/json.hpp>

#include "calib/work/printable.h"
#include "pipeline/commands/partial_build.h"
#include "pipeline/line/chosen_workspace.h"
#include "pipeline/line/line.h"
#include "pipeline/line/stages_file.h"
#include "pipeline/report/workspace_report.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/folder_size.h"

namespace lumi {
namespace {

std::string seconds_table(const std::vector<FinishedStage>& stages) {
    std::string table = "stage      state        seconds      CPU s   peak MiB\n";
    for (const FinishedStage& stage : stages) {
        table += padded_right(stage.name, 11) +
                 padded_right(stage.was_run ? "run" : "up to date", 10) +
                 padded_left(number_text(stage.cost.wall_s, 2), 10) +
                 padded_left(number_text(stage.cost.cpu_s, 2), 11) +
                 padded_left(number_text(stage.cost.peak_mib, 0), 11) + "\n";
    }
    return table;
}

std::string evidence_text(const std::vector<FinishedStage>& stages) {
    std::string text;
    for (const FinishedStage& stage : stages) {
        text += stage.name + ": " + stage.evidence.facts_json;
    }
    return text;
}

/// What to do with a package that was built.
std::string next_steps(const Workspace& workspace) {
    const std::string package = printable(workspace.package_folder().string());
    return "next: lumi view \"" + package + "\" (" +
           number_text(folder_mib(workspace.package_folder()), 1) +
           " MiB, all that another computer with lumi needs)\nwhat was used, left out and why: " +
           printable(workspace.report_path().string()) + "\n";
}

}  // namespace

void run_build(const BuildRequest& request, const std::string& last_stage,
               const CommandContext& context) {
    const BuildConfig config = load_build_config(request.config);
    const Workspace workspace(layout_for(request.workspace, config, context.threads));
    const int threads = context.threads > 0 ? context.threads : config.threads;
    std::vector<FinishedStage> stages;
    work_and_report(workspace, [&] {
        stages = run_line(config, workspace, last_stage, threads, *context.progress);
    });

    context.say("\n" + seconds_table(stages));
    if (context.verbosity > 0) context.say(evidence_text(stages));
    if (context.json) {
        context.print_result(stages_json(stages));
    } else {
        const std::filesystem::path made =
            last_stage == "pack" ? workspace.package_folder() : workspace.stage_folder(last_stage);
        context.print_result(made.string() + "\n");
    }
    if (last_stage == "pack") context.say(next_steps(workspace));
    refuse_partial(placed_photographs(stages), workspace);
}

}  // namespace lumi
