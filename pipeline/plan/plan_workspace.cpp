#include "pipeline/plan/plan_workspace.h"

#include <nlohmann/json.hpp>
#include <numeric>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "meshing/cameras/camera_mesh_builder.h"
#include "meshing/cameras/mesh_picture.h"
#include "pipeline/stages/mesh_stage.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Capture capture_with_poses(const Workspace& workspace) {
    const fs::path pinhole_folder = workspace.stage_folder("poses") / "pinhole";
    std::error_code status;
    if (!fs::is_directory(pinhole_folder, status)) {
        throw Error(ErrorKind::kBadInput, "E-PLAN-NOPOSES",
                    workspace.folder().string() + ": no poses have been found yet",
                    "run `lumi poses CONFIG.toml` first");
    }
    return read_posed_photographs(pinhole_folder).capture;
}

std::string name_at(const WorkspacePlan& planned, int view) {
    return view < 0 ? std::string() : planned.view_names[static_cast<std::size_t>(view)];
}

Json suggestion_json(const SuggestedView& view, const WorkspacePlan& planned) {
    const Eigen::Quaterniond& q = view.cam_from_world.rotation;
    const Eigen::Vector3d& t = view.cam_from_world.translation;
    const Eigen::Vector3d centre = centre_in_world(view.cam_from_world);
    Json from = Json::array();
    for (std::size_t i = 0; i < 2; ++i) {
        if (view.nearest_views[i] < 0) continue;
        from.push_back(
            {{"name", name_at(planned, view.nearest_views[i])}, {"steps", view.steps[i]}});
    }
    return Json{{"rotation_wxyz", {q.w(), q.x(), q.y(), q.z()}},
                {"translation", {t.x(), t.y(), t.z()}},
                {"centre_in_world", {centre.x(), centre.y(), centre.z()}},
                {"predicted_error_px", view.error_px},
                {"worst_error_after_px", view.worst_error_after_px},
                {"from", std::move(from)}};
}

}  // namespace

Json plan_json(const WorkspacePlan& planned) {
    Json holes = Json::array();
    for (const Hole& hole : planned.plan.holes) {
        Json names = Json::array();
        for (const int view : hole.view_indices) names.push_back(name_at(planned, view));
        holes.push_back({{"between", std::move(names)},
                         {"radius_rad", hole.radius_rad},
                         {"predicted_error_px", hole.error_px}});
    }
    Json suggestions = Json::array();
    for (const SuggestedView& view : planned.plan.suggestions) {
        suggestions.push_back(suggestion_json(view, planned));
    }
    return Json{{"focal_length_px", planned.plan.uncertainty.focal_length_px},
                {"inverse_depth_uncertainty", planned.plan.uncertainty.inverse_depth},
                {"photographs_for_wish", planned.plan.photographs_for_wish},
                {"suggestions", std::move(suggestions)},
                {"faces", std::move(holes)}};
}

std::string plan_text(const WorkspacePlan& planned) {
    const CapturePlan& plan = planned.plan;
    if (plan.holes.empty()) return "nothing lies between the cameras that could be planned\n";
    std::string text =
        "by the poses alone, what neighbouring photographs show of one point falls apart between "
        "the cameras by " +
        number_text(plan.holes.front().error_px, 2) + " px at worst, " +
        number_text(plan.holes[plan.holes.size() / 2].error_px, 2) +
        " px usually;\nwhat is hidden, or lies past the border of the capture, is not counted\n";
    for (std::size_t i = 0; i < plan.suggestions.size(); ++i) {
        const SuggestedView& view = plan.suggestions[i];
        text += std::to_string(i + 1) + ". " + number_text(view.error_px, 2) + " px here; " +
                number_text(view.worst_error_after_px, 2) + " px at worst with it\n";
        for (std::size_t from = 0; from < 2; ++from) {
            if (view.nearest_views[from] < 0) continue;
            text += "   from where " + name_at(planned, view.nearest_views[from]) + " was taken " +
                    view.steps[from] + "\n";
        }
        text += "   and look at the middle of the subject\n";
    }
    return text;
}

WorkspacePlan plan_workspace(const Workspace& workspace, const CapturePlanOptions& options) {
    const Capture capture = capture_with_poses(workspace);
    std::vector<int> views(capture.views.size());
    std::iota(views.begin(), views.end(), 0);
    WorkspacePlan planned{plan_capture(capture, views, options), view_names(capture)};

    std::vector<Rigid3> suggested;
    for (const SuggestedView& view : planned.plan.suggestions) {
        suggested.push_back(view.cam_from_world);
    }
    const CameraMesh mesh =
        build_camera_mesh(capture, views, camera_mesh_options_of(workspace.config_path())).mesh;
    WholeFolder folder(workspace.folder() / "plan");
    write_json_file(folder.staging() / kPlanName, plan_json(planned));
    write_whole_text(folder.staging() / "plan.svg",
                     camera_mesh_svg(capture, views, mesh, suggested));
    folder.keep_files_of_others([](const std::string&) { return false; });
    folder.put_in_place();
    return planned;
}

}  // namespace lumi
