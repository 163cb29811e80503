#include "pipeline/evaluate/held_out_beside.h"

#include "calib/capture/image_io.h"
#include "pipeline/evaluate/held_out_photographs.h"

namespace lumi {

std::vector<HeldOutView> held_out_views_beside(const std::filesystem::path& package_folder) {
    const std::filesystem::path folder = folder_around(package_folder);
    std::error_code status;
    if (!std::filesystem::is_regular_file(folder / "pack" / "pack.json", status)) return {};
    const WorkspaceLayout workspace = find_workspace(folder);
    if (!std::filesystem::equivalent(workspace.package_folder(), package_folder, status)) return {};
    const PackRecord record = read_pack_record(workspace.stage_folder("pack"));
    if (record.held_out.empty()) return {};
    const PosedPhotographs photographs = held_out_photographs(workspace, record, 0);
    std::vector<HeldOutView> held_out;
    for (std::size_t i = 0; i < photographs.capture.views.size(); ++i) {
        const View& view = photographs.capture.views[i];
        held_out.push_back({view.name,
                            {camera_of(photographs.capture, view), view.cam_from_world},
                            read_color_image(photographs.picture_paths[i])});
    }
    return held_out;
}

}  // namespace lumi
