#include "calib/work/whole_file.h"
#include "pipeline/report/lens_tables.h"
#include "pipeline/report/sections.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What the mesh looks like, and how it came about.
std::string mesh_part(const ReportSources& sources) {
    const Json mesh = evidence_of(sources.stages, "mesh");
    if (mesh.is_null()) return {};
    std::string html = "<p>" + html_escaped(text_of(mesh.at("explanation"))) + "</p>\n";
    const fs::path svg_path = sources.workspace.stage_folder("mesh") / "camera_mesh.svg";
    std::error_code status;
    if (fs::is_regular_file(svg_path, status)) {
        html += html_svg_figure(read_whole_text(svg_path),
                                "The cameras and the mesh that says which of them a ray is "
                                "blended from");
    }
    return html;
}

std::string mesh_figures(const ReportSources& sources) {
    Json mesh = evidence_of(sources.stages, "mesh");
    if (mesh.is_null()) return {};
    mesh.erase("explanation");
    return html_details("Figures of the camera mesh", table_of_values(mesh));
}

std::string pose_figures(const Json& poses) {
    std::string html = table_of_values(poses);
    for (const Json& lens : poses.at("lenses")) html += lens_table(lens);
    return html_details("Figures of the poses", html + pose_uncertainty_table(poses));
}

}  // namespace

std::string cameras_section(const ReportSources& sources) {
    const Json poses = evidence_of(sources.stages, "poses");
    if (poses.is_null()) return {};
    std::string html = mesh_part(sources);
    html += "<p>Scene points are seen " +
            number_text(poses.at("mean_reprojection_error_px").get<double>(), 2) +
            " pixels, on average, from where the cameras say they should be.</p>\n";
    return html_section("Cameras", html + pose_figures(poses) + mesh_figures(sources));
}

}  // namespace lumi
