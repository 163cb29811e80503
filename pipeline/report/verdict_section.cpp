#include "pipeline/report/sections.h"
#include "pipeline/report/verdict.h"
#include "pipeline/text/html.h"

namespace lumi {

std::string verdict_section(const ReportSources& sources) {
    const Verdict verdict = verdict_of(sources.stages, sources.package, sources.evaluation);
    const char* style = verdict.level == Verdict::Level::kGood   ? "good"
                        : verdict.level == Verdict::Level::kFair ? "fair"
                                                                 : "bad";
    std::string html = std::string("<div class=\"verdict ") + style + "\"><strong>" +
                       html_escaped(verdict.headline) + "</strong>";
    for (const std::string& remark : verdict.remarks) html += "<br>" + html_escaped(remark);
    return html + "</div>\n";
}

}  // namespace lumi
