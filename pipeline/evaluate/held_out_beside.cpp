#include "pipeline/evaluate/held_out_beside.h"

#include <map>
#include <optional>

#include "calib/pictures/image_io.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/stages/photograph_list.h"
#include "render/lumigraph/even_exposure.h"
#include "render/paths/photograph_eye.h"

namespace lumi {
namespace {

/// Whose package it is, if there is one that says what it held out.
std::optional<WorkspaceLayout> workspace_around(const std::filesystem::path& package_folder) {
    const std::filesystem::path folder = folder_around(package_folder);
    std::error_code status;
    if (!std::filesystem::is_regular_file(folder / "pack" / "pack.json", status)) return {};
    if (!is_workspace(folder)) return {};
    WorkspaceLayout workspace = find_workspace(folder);
    if (!std::filesystem::equivalent(workspace.package_folder(), package_folder, status)) return {};
    return workspace;
}

}  // namespace

std::vector<std::string> held_out_names_beside(const std::filesystem::path& package_folder) {
    const std::optional<WorkspaceLayout> workspace = workspace_around(package_folder);
    if (!workspace) return {};
    return read_pack_record(workspace->stage_folder("pack")).held_out;
}

std::vector<HeldOutView> held_out_views_beside(const std::filesystem::path& package_folder,
                                               double light_falloff) {
    const std::optional<WorkspaceLayout> workspace = workspace_around(package_folder);
    if (!workspace) return {};
    const PackRecord record = read_pack_record(workspace->stage_folder("pack"));
    if (record.held_out.empty()) return {};
    const PosedPhotographs photographs = held_out_photographs(*workspace, record, 0);
    std::map<std::string, int> orientation_of;
    for (const Photograph& photograph :
         read_photograph_list(workspace->stage_folder("ingest")).photographs)
        orientation_of[photograph.name] = photograph.exif_orientation;
    std::vector<HeldOutView> held_out;
    for (std::size_t i = 0; i < photographs.capture.views.size(); ++i) {
        const View& view = photographs.capture.views[i];
        const int orientation = orientation_of.at(view.name);
        const Eye eye{camera_of(photographs.capture, view), view.cam_from_world};
        ColorImage photograph = without_falloff(read_color_image(photographs.picture_paths[i]),
                                                eye.camera, light_falloff);
        held_out.push_back(
            {view.name, turned_upright(eye, orientation), turned_upright(photograph, orientation)});
    }
    return held_out;
}

}  // namespace lumi
