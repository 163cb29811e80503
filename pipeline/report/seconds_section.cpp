#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {

std::string seconds_section(const ReportSources& sources) {
    TableRows rows;
    double wall_s = 0.0;
    double cpu_s = 0.0;
    for (const nlohmann::ordered_json& stage : sources.stages.at("stages")) {
        rows.push_back({text_of(stage.at("name")), text_of(stage.at("state")),
                        number_text(stage.at("wall_s").get<double>(), 2),
                        number_text(stage.at("cpu_s").get<double>(), 2),
                        number_text(stage.at("peak_mib").get<double>(), 0)});
        wall_s += stage.at("wall_s").get<double>();
        cpu_s += stage.at("cpu_s").get<double>();
    }
    return html_section(
        "Seconds",
        "<p>" + number_text(wall_s, 1) + " seconds in all, " + number_text(cpu_s, 1) +
            " CPU seconds.</p>\n" +
            html_details(
                "Every stage",
                html_table({"stage", "state", "seconds", "CPU seconds", "peak MiB"}, rows)));
}

}  // namespace lumi
