#include "meshing/cameras/repair.h"

#include "meshing/cameras/construction.h"
#include "meshing/cameras/edge_flips.h"
#include "meshing/cameras/scene_hull.h"

namespace lumi {
namespace {

/// Parts of the scene that are tried in turn.
constexpr double kScenePartShares[] = {1.0, 0.8, 0.5};

}  // namespace

RepairReport repair_kernel(CameraMesh& mesh, const RepairRules& rules) {
    RepairReport report;
    if (mesh.faces.empty() || rules.scene_in_world.empty()) return report;
    for (const double part : kScenePartShares) {
        const std::vector<Eigen::Vector3d> hull = scene_hull(rules.scene_in_world, part);
        if (scene_clearance(mesh, hull) >= 0) return report;
        if (part == 1.0 && is_surface(mesh)) {
            report.edges_flipped = flip_edges_for_room(mesh, hull, 0.0);
            if (scene_clearance(mesh, hull) >= 0) return report;
        }
        CameraMesh slid = mesh;
        const SlideReport slide = slide_into_kernel(slid, hull);
        if (!slide.reached || scene_clearance(slid, hull) < 0) continue;
        mesh = std::move(slid);
        report.slide = slide;
        report.epipole_loss = epipole_loss(mesh, rules.centre_of_view, hull);
        return report;
    }
    return report;
}

}  // namespace lumi
