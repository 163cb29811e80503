#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "pipeline/commands/commands.h"
#include "pipeline/stages/drawing_effort.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/folder_size.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json package_json(const Lumigraph& lumigraph, double mib) {
    Json views = Json::array();
    for (const LumigraphView& view : lumigraph.views) {
        const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
        views.push_back({{"name", view.name},
                         {"width_px", view.camera.width_px},
                         {"height_px", view.camera.height_px},
                         {"focal_length_px", focal_length_px(view.camera).x()},
                         {"centre_in_world", {centre.x(), centre.y(), centre.z()}},
                         {"exposure_gain", view.exposure_gain},
                         {"depth_width_px", view.depth.inverse_depth.width()},
                         {"depth_height_px", view.depth.inverse_depth.height()}});
        if (view.depth_mesh) {
            views.back()["depth_mesh"] = {{"triangles", view.depth_mesh->indices.size() / 3},
                                          {"wanted_error_px", view.depth_mesh->wanted_error_px},
                                          {"error_px", view.depth_mesh->error_px}};
        }
    }
    return Json{{"name", lumigraph.name},
                {"mib", mib},
                {"near_depth", lumigraph.near_depth},
                {"far_depth", lumigraph.far_depth},
                {"light_falloff", lumigraph.light_falloff},
                {"occlusion_tolerance_px", lumigraph.drawing.occlusion_tolerance_px},
                {"noisy_depth_error_px", lumigraph.noisy_depth_error_px},
                {"depth_views", lumigraph.drawing.depth_views},
                {"depth_block_px", lumigraph.drawing.depth_block_px},
                {"fills_holes", lumigraph.drawing.fills_holes},
                {"checks_guesses", lumigraph.drawing.checks_guesses},
                {"triangle_error_px", lumigraph.drawing.triangle_error_px},
                {"draws_thin", lumigraph.drawing.draws_thin},
                {"mesh",
                 {{"construction", name_of(lumigraph.mesh.construction)},
                  {"vertices", lumigraph.mesh.vertices.size()},
                  {"faces", lumigraph.mesh.faces.size()}}},
                {"views", std::move(views)}};
}

/// Nothing for a photograph that needs no evening.
std::string gain_text(const LumigraphView& view) {
    if (view.exposure_gain == kNoExposureGain) return "";
    return "  light times " + number_text(view.exposure_gain[0], 3) + " " +
           number_text(view.exposure_gain[1], 3) + " " + number_text(view.exposure_gain[2], 3);
}

/// Nothing for photographs that do not darken towards their corners.
std::string falloff_text(const Lumigraph& lumigraph) {
    if (lumigraph.light_falloff == 0) return "";
    const double left = lumigraph.light_left_in_corners();
    return ", corners darker by up to " + number_text(100 * (1 - left), 0) + " % of their light";
}

std::string package_text(const Lumigraph& lumigraph, double mib) {
    std::string text =
        lumigraph.name + ": " + number_text(mib, 1) + " MiB, " +
        counted(lumigraph.views.size(), "view") + ", depth " +
        number_text(lumigraph.near_depth, 3) + " to " + number_text(lumigraph.far_depth, 3) +
        ", camera mesh " + name_of(lumigraph.mesh.construction) + " with " +
        std::to_string(lumigraph.mesh.vertices.size()) +
        (lumigraph.mesh.vertices.size() == 1 ? " vertex and " : " vertices and ") +
        counted(lumigraph.mesh.faces.size(), "face") + ", depth compared from " +
        counted(lumigraph.drawing.depth_views, "view") + " for " +
        text_of_depth_blocks(lumigraph.drawing.depth_block_px) +
        ", views blended unless they see something else by " +
        number_text(lumigraph.drawing.occlusion_tolerance_px, 1) + " px" +
        ", noisy depth followed to " + number_text(lumigraph.noisy_depth_error_px, 2) + " px" +
        (lumigraph.drawing.fills_holes ? ", what these do not see drawn from others" : "") +
        (lumigraph.drawing.checks_guesses ? ", guesses checked" : "") + ", triangles within " +
        number_text(lumigraph.drawing.triangle_error_px, 2) + " px" +
        (lumigraph.drawing.draws_thin ? ", what is thinner drawn over them" : "") +
        falloff_text(lumigraph) + "\n";
    for (const LumigraphView& view : lumigraph.views) {
        text += view.name + "  " + std::to_string(view.camera.width_px) + "x" +
                std::to_string(view.camera.height_px) + "  focal length " +
                number_text(focal_length_px(view.camera).x(), 1) + " px" + gain_text(view) + "\n";
    }
    return text;
}

}  // namespace

void add_inspect_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(app, "inspect", "What is in a package",
                                    "lumi inspect work/fountain/fountain.lumi");
    const auto package = std::make_shared<std::filesystem::path>();
    command.add_option("PACKAGE", *package, "Folder NAME.lumi")->required();
    command.callback([package, &context] {
        context.chosen = [package, &context] {
            const Lumigraph lumigraph = read_package(*package, {}, Exposures::kAsTaken);
            const double mib = folder_mib(*package);
            if (context.json) {
                context.print_result(package_json(lumigraph, mib));
            } else {
                context.print_result(package_text(lumigraph, mib));
            }
        };
    });
}

}  // namespace lumi
