#include "pipeline/commands/run_build.h"

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "pipeline/line/line.h"
#include "pipeline/line/stages_file.h"
#include "pipeline/report/number_text.h"
#include "pipeline/report/padded.h"
#include "pipeline/report/workspace_report.h"

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

Workspace open_workspace(const BuildRequest& request, const BuildConfig& config) {
    if (request.workspace.empty()) return Workspace(workspace_of(config));
    return Workspace(WorkspaceLayout(request.workspace, config.name));
}

/// A report that tells why is worth most when there is no package; but what ended the line must not
/// be lost over it.
void write_report_of_failure(const Workspace& workspace) {
    try {
        write_workspace_report(workspace);
    } catch (const Error&) {
        return;
    }
}

std::vector<FinishedStage> run_and_report(const BuildConfig& config, const Workspace& workspace,
                                          const std::string& last_stage,
                                          const CommandContext& context) {
    const int threads = context.threads > 0 ? context.threads : config.threads;
    try {
        std::vector<FinishedStage> stages =
            run_line(config, workspace, last_stage, threads, *context.progress);
        write_workspace_report(workspace);
        return stages;
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::kInterrupted) write_report_of_failure(workspace);
        throw;
    }
}

}  // namespace

void run_build(const BuildRequest& request, const std::string& last_stage,
               const CommandContext& context) {
    const BuildConfig config = load_build_config(request.config);
    const Workspace workspace = open_workspace(request, config);
    const std::vector<FinishedStage> stages =
        run_and_report(config, workspace, last_stage, context);

    context.say("\n" + seconds_table(stages));
    if (context.verbosity > 0) context.say(evidence_text(stages));
    if (context.json) {
        context.print_result(stages_json(stages));
        return;
    }
    const std::filesystem::path made =
        last_stage == "pack" ? workspace.package_folder() : workspace.stage_folder(last_stage);
    context.print_result(made.string() + "\n");
}

}  // namespace lumi
