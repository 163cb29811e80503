#include <exception>
#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

struct KnownChart {
    fs::path path;
    const char* caption;
};

/// What a package that is gone could bear would be read as this one's.
bool is_of_this_package(const fs::path& stress_folder, const WorkspaceLayout& workspace) {
    std::error_code status;
    const fs::path figures = stress_folder / "stress.json";
    if (!fs::is_regular_file(figures, status)) return false;
    try {
        return read_json_file(figures).value("package_sha256", "") == package_sha256(workspace);
    } catch (const std::exception&) {
        return false;  // One of the two is damaged, or not there.
    }
}

}  // namespace

std::string charts_section(const ReportSources& sources) {
    const fs::path& folder = sources.workspace.folder();
    const fs::path sweep = folder.string() + "-chart";
    const fs::path stress = folder / "stress";
    std::vector<KnownChart> charts{
        {sweep / "end-to-end.svg", "Speed against accuracy, end to end (lumi chart)"},
        {sweep / "drawing.svg", "Speed against accuracy of drawing (lumi chart)"}};
    if (is_of_this_package(stress, sources.workspace)) {
        charts.push_back({stress / "pose_rotation_deg.svg", "What wrong poses cost (lumi stress)"});
        charts.push_back({stress / "depth_percent.svg", "What wrong depth costs (lumi stress)"});
        charts.push_back(
            {stress / "views_dropped_percent.svg", "What fewer photographs cost (lumi stress)"});
    }
    std::string html;
    for (const KnownChart& chart : charts) {
        std::error_code status;
        if (!fs::is_regular_file(chart.path, status)) continue;
        html += html_svg_figure(read_whole_text(chart.path), chart.caption);
    }
    return html.empty() ? html : html_section("Charts", html_grid(html));
}

}  // namespace lumi
