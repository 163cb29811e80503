#include "calib/work/whole_file.h"
#include "pipeline/line/versions.h"
#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

std::string pre(const std::string& text) { return "<pre>" + html_escaped(text) + "</pre>\n"; }

/// The programs that the poses stage drove, as a user would type them.
std::string command_lines(const ReportSources& sources) {
    const Json timings = evidence_of(sources.stages, "poses", "timings");
    if (timings.is_null()) return {};
    std::string calls;
    for (const Json& call : timings.value("colmap_calls", Json::array())) {
        calls += number_text(call.at("wall_s").get<double>(), 1) + " s  " +
                 text_of(call.at("command_line")) + "\n";
    }
    return calls.empty() ? calls : html_details("COLMAP, as it was called", pre(calls));
}

}  // namespace

std::string repetition_section(const ReportSources& sources) {
    std::string html = html_details("Every setting, with defaults filled in",
                                    pre(read_whole_text(sources.workspace.config_path())));
    html += command_lines(sources) + html_details("Versions", pre(version_text()));
    return html_section("To do it again", html);
}

}  // namespace lumi
