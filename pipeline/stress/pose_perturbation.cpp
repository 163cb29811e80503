#include <Eigen/Geometry>
#include <numbers>

#include "calib/work/median.h"
#include "meshing/warp/parallax.h"
#include "pipeline/stress/perturbation.h"
#include "pipeline/stress/seeded_normal.h"

namespace lumi {
namespace {

/// The median distance from a camera to its nearest neighbour, be it of the same burst: errors of
/// poses are to be small beside what tells cameras apart.
double camera_spacing(const Lumigraph& lumigraph) {
    std::vector<Eigen::Vector3d> centres;
    for (const LumigraphView& view : lumigraph.views) {
        centres.push_back(centre_in_world(view.cam_from_world));
    }
    return centres.size() < 2 ? 0.0 : median_of(nearest_distances(centres));
}

void move_vertices(CameraMesh& mesh, const std::vector<Eigen::Vector3d>& shift_of_view) {
    for (CameraMesh::Vertex& vertex : mesh.vertices) {
        vertex.position_in_world += shift_of_view[static_cast<std::size_t>(vertex.view_index)];
    }
    for (CameraMesh& shell : mesh.shells) move_vertices(shell, shift_of_view);
}

}  // namespace

Lumigraph with_turned_poses(const Lumigraph& lumigraph, double sigma_deg, std::uint64_t seed) {
    const SeededNormal random(seed);
    Lumigraph result = lumigraph;
    for (std::size_t i = 0; i < result.views.size(); ++i) {
        Rigid3& cam_from_world = result.views[i].cam_from_world;
        const Eigen::Vector3d axis = random.vector(2 * i).normalized();
        const double angle = sigma_deg * std::numbers::pi / 180.0 * random.value(2 * i + 1, 0);
        const Eigen::Vector3d centre = centre_in_world(cam_from_world);
        cam_from_world.rotation =
            (Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis)) * cam_from_world.rotation)
                .normalized();
        cam_from_world.translation = -(cam_from_world.rotation * centre);
    }
    return result;
}

Lumigraph with_moved_poses(const Lumigraph& lumigraph, double share_percent, std::uint64_t seed) {
    const SeededNormal random(seed);
    const double sigma = share_percent / 100.0 * camera_spacing(lumigraph);
    Lumigraph result = lumigraph;
    std::vector<Eigen::Vector3d> shifts;
    for (std::size_t i = 0; i < result.views.size(); ++i) {
        Rigid3& cam_from_world = result.views[i].cam_from_world;
        shifts.push_back(sigma * random.vector(i));
        cam_from_world.translation -= cam_from_world.rotation * shifts.back();
    }
    // The mesh stands where the cameras are said to stand; its skirt goes with them.
    move_vertices(result.mesh, shifts);
    return result;
}

Lumigraph with_longer_focal_length(const Lumigraph& lumigraph, double percent,
                                   std::uint64_t /*seed*/) {
    Lumigraph result = lumigraph;
    for (LumigraphView& view : result.views) {
        view.camera.parameters[0] *= 1.0 + percent / 100.0;  // A pinhole's fx and fy.
        view.camera.parameters[1] *= 1.0 + percent / 100.0;
    }
    return result;
}

}  // namespace lumi
