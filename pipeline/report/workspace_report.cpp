#include "pipeline/report/workspace_report.h"

#include "calib/work/whole_file.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {

void write_workspace_report(const WorkspaceLayout& workspace) {
    const ReportSources sources{workspace, read_json_file(workspace.stages_path()),
                                read_current_evaluation(workspace)};
    std::string body;
    for (const auto section :
         {&verdict_section, &pictures_section, &charts_section, &cameras_section, &depth_section,
          &figures_section, &photographs_section, &seconds_section, &repetition_section}) {
        body += section(sources);
    }
    write_whole_text(workspace.report_path(), html_page(workspace.name(), body));
}

}  // namespace lumi
