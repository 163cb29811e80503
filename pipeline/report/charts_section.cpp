#include <array>

#include "calib/work/whole_file.h"
#include "pipeline/report/sections.h"
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
    const std::array<KnownChart, 5> charts{
        {{sweep / "end-to-end.svg", "Speed against accuracy, end to end (lumi chart)"},
         {sweep / "drawing.svg", "Speed against accuracy of drawing (lumi chart)"},
         {folder / "stress" / "pose_rotation_deg.svg", "What wrong poses cost (lumi stress)"},
         {folder / "stress" / "depth_percent.svg", "What wrong depth costs (lumi stress)"},
         {folder / "stress" / "views_dropped_percent.svg",
          "What fewer photographs cost (lumi stress)"}}};
    std::string html;
    for (const KnownChart& chart : charts) {
        std::error_code status;
        if (!fs::is_regular_file(chart.path, status)) continue;
        html += html_svg_figure(read_whole_text(chart.path), chart.caption);
    }
    return html.empty() ? html : html_section("Charts", html_grid(html));
}

}  // namespace lumi
