#include "pipeline/commands/run_build.h"

#include <nlohmann/json.hpp>

#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "pipeline/config/plain_capture.h"
#include "pipeline/line/line.h"
#include "pipeline/line/placed_photographs.h"
#include "pipeline/line/stages_file.h"
#include "pipeline/report/workspace_report.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

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

/// Folders of one name, each given without a configuration, would take each other's place.
void expect_no_other_capture(const WorkspaceLayout& layout, const BuildConfig& config) {
    std::error_code status;
    if (!fs::exists(layout.config_path(), status)) return;
    ConfigSection capture = ConfigSection::from_file(layout.config_path()).section("capture");
    for (const char* source : {"photos", "video"}) {
        const fs::path before = capture.text(source, "");
        if (before.empty() || !fs::exists(before, status) ||
            fs::equivalent(before, config.photographs_or_video, status))
            continue;
        throw Error(
            ErrorKind::kUsage, "E-WORKSPACE-OTHER",
            layout.folder().string() + ": holds what was made of " + printable(before.string()),
            "name another folder with --workspace");
    }
}

Workspace open_workspace(const BuildRequest& request, const BuildConfig& config) {
    if (request.workspace.empty()) {
        const WorkspaceLayout layout = workspace_of(config);
        if (plain_capture(request.config)) expect_no_other_capture(layout, config);
        return Workspace(layout);
    }
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

/// What was made stands, and is not what was asked for.
void refuse_partial(const std::vector<FinishedStage>& stages, const WorkspaceLayout& layout) {
    const auto photographs = placed_photographs(stages);
    if (!photographs || !photographs->is_partial()) return;
    throw Error(ErrorKind::kPartialResult, "E-BUILD-PARTIAL",
                "only " + std::to_string(photographs->placed) + " of " +
                    std::to_string(photographs->total) +
                    " photographs found a place, and what was made shows what these show",
                layout.report_path().string() +
                    " says why of each; photographs between those that are far apart join them");
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
    } else {
        const std::filesystem::path made =
            last_stage == "pack" ? workspace.package_folder() : workspace.stage_folder(last_stage);
        context.print_result(made.string() + "\n");
    }
    refuse_partial(stages, workspace);
}

}  // namespace lumi
