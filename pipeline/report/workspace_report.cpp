#include "pipeline/report/workspace_report.h"

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/error_of_exception.h"
#include "calib/work/json_fault.h"
#include "calib/work/whole_file.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// Null when it is of another package, of none that it names, or damaged.
Json current_target(const WorkspaceLayout& workspace) {
    const auto path = workspace.folder() / "target.json";
    std::error_code status;
    if (!std::filesystem::is_regular_file(path, status)) return nullptr;
    try {
        const Json target = read_json_file(path);
        const auto of_package = target.find("package_sha256");
        const bool is_current =
            of_package != target.end() && *of_package == package_sha256(workspace);
        return is_current ? target : Json();
    } catch (const Error&) {
        return nullptr;
    }
}

/// Figures of a package that the settings beside them did not make would mislead.
ReportSources sources_of(const WorkspaceLayout& workspace) {
    Json stages = read_json_file(workspace.stages_path());
    const StandingPackage package = standing_package(workspace, stages);
    ReportSources sources{workspace, std::move(stages), package, {}, {}};
    if (!package.exists || package.is_former()) return sources;
    sources.evaluation = read_current_evaluation(workspace);
    sources.target = current_target(workspace);
    return sources;
}

std::string body_of(const ReportSources& sources) {
    std::string body;
    for (const auto section : {&verdict_section, &target_section, &pictures_section,
                               &charts_section, &cameras_section, &depth_section, &figures_section,
                               &photographs_section, &seconds_section, &repetition_section}) {
        body += section(sources);
    }
    return body;
}

/// A report that tells why is worth most when there is no package; but what ended the work must not
/// be lost over it.
void write_report_of_failure(const WorkspaceLayout& workspace) {
    try {
        write_workspace_report(workspace);
    } catch (const std::exception&) {
        return;
    }
}

}  // namespace

void write_workspace_report(const WorkspaceLayout& workspace) {
    try {
        const std::string body = body_of(sources_of(workspace));
        write_whole_text(workspace.report_path(), html_page(workspace.name(), body));
    } catch (const Json::exception& fault) {
        throw Error(ErrorKind::kBadInput, "E-JSON-READ",
                    json_fault(workspace.folder().string() +
                                   ": stages.json or what was measured lacks what it should say",
                               fault),
                    "run `lumi build` again, to its end, and then `lumi evaluate`");
    }
}

void work_and_report(const WorkspaceLayout& workspace, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& exception) {
        const std::optional<Error> error = error_of_exception(exception);
        if (error && error->kind() != ErrorKind::kInterrupted) write_report_of_failure(workspace);
        throw;
    }
    write_workspace_report(workspace);
}

}  // namespace lumi
