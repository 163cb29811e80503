#include "pipeline/stages/mesh_stage.h"

#include <nlohmann/json.hpp>

#include "calib/capture/all_views.h"
#include "calib/work/config_section.h"
#include "calib/work/whole_file.h"
#include "meshing/cameras/mesh_picture.h"
#include "meshing/surface/mesh_io.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {

CameraMeshOptions camera_mesh_options_of(const std::filesystem::path& configuration) {
    return read_camera_mesh_options(ConfigSection::from_file(configuration).section("mesh"));
}

StageEvidence run_mesh_stage(const Capture& capture, const CameraMeshOptions& options,
                             const std::filesystem::path& folder) {
    const std::vector<int> views = all_views(capture);
    const BuiltCameraMesh built = build_camera_mesh(capture, views, options);
    write_camera_mesh_ply(folder / "camera_mesh.ply", built.mesh);
    write_whole_text(folder / "camera_mesh.svg", camera_mesh_svg(capture, views, built.mesh));

    const CameraMeshEvidence& evidence = built.evidence;
    const nlohmann::ordered_json facts{
        {"construction", name_of(built.mesh.construction)},
        {"cameras_total", evidence.cameras_total},
        {"cameras_kept", evidence.cameras_kept},
        {"close_ups", evidence.close_ups},
        {"shells", evidence.shells},
        {"vertices", built.mesh.vertices.size()},
        {"faces", built.mesh.faces.size()},
        {"kernel_radius_over_scene_radius", evidence.kernel_radius_over_scene_radius},
        {"faces_with_scene_outside", evidence.faces_with_scene_outside},
        {"scene_share_in_kernel", evidence.scene_share_in_kernel},
        {"edges_flipped", evidence.edges_flipped},
        {"cameras_slid", evidence.cameras_slid},
        {"largest_slide_share", evidence.largest_slide_share},
        {"rms_slide_share", evidence.rms_slide_share},
        {"own_ray_share", evidence.own_ray_share},
        {"worst_epipole_loss", evidence.worst_epipole_loss},
        {"rms_epipole_loss", evidence.rms_epipole_loss},
        {"epipole_loss_bound", evidence.epipole_loss_bound},
        {"explanation", evidence.explanation}};
    return {json_text(facts), "{}"};
}

}  // namespace lumi
