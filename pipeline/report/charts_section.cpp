#include "calib/work/whole_file.h"
#include "pipeline/report/sections.h"
#include "pipeline/report/stress_charts.h"
#include "pipeline/text/html.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

struct KnownChart {
    fs::path path;
    const char* caption;
};

}  // namespace

std::string charts_section(const ReportSources& sources) {
    const fs::path& folder = sources.workspace.folder();
    const fs::path sweep = folder.string() + "-chart";
    std::vector<KnownChart> charts{
        {sweep / "end-to-end.svg", "Speed against accuracy, end to end (lumi chart)"},
        {sweep / "drawing.svg", "Speed against accuracy of drawing (lumi chart)"}};
    const auto of_stress = stress_charts_of(sources.workspace);
    const auto add_of_stress = [&](const char* perturbation, const char* caption) {
        const auto chart = of_stress.find(perturbation);
        if (chart != of_stress.end()) charts.push_back({chart->second, caption});
    };
    add_of_stress("pose_rotation_deg", "What wrong poses cost (lumi stress)");
    add_of_stress("depth_percent", "What wrong depth costs (lumi stress)");
    add_of_stress("views_dropped_percent", "What fewer photographs cost (lumi stress)");
    std::string html;
    for (const KnownChart& chart : charts) {
        std::error_code status;
        if (!fs::is_regular_file(chart.path, status)) continue;
        html += html_svg_figure(read_whole_text(chart.path), chart.caption);
    }
    return html.empty() ? html : html_section("Charts", html_grid(html));
}

}  // namespace lumi
