#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> achievement_row(const std::string& what, const Json& achievement) {
    return {what, text_of(achievement.at("psnr_db")), text_of(achievement.at("frames_per_second")),
            text_of(achievement.at("package_mib")), text_of(achievement.at("build_s"))};
}

}  // namespace

std::string target_section(const ReportSources& sources) {
    const Json& target = sources.target;
    if (target.is_null()) return {};
    const std::string mode = text_of(target.at("mode"));
    std::string html =
        "<p>" + html_escaped(text_of(target.at("wish"))) + " was wished for, and " +
        (target.at("is_met").get<bool>() ? "is met" : "is out of reach: this is the nearest") +
        ". Settings were measured on the held-out photographs, and these were chosen, to be drawn "
        "in the mode " +
        html_escaped(mode) + ":</p>\n<ul>\n";
    for (const Json& setting : target.at("settings"))
        html += "<li><code>" + html_escaped(text_of(setting)) + "</code></li>\n";
    html += "</ul>\n" +
            html_table({"", "PSNR (dB)", "frames a second", "MiB", "seconds to build"},
                       {achievement_row("promised by the chart", target.at("promised")),
                        achievement_row("measured on the package", target.at("delivered"))});
    return html_section("What was wished for", html);
}

}  // namespace lumi
