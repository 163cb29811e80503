#include "pipeline/evaluate/view_place.h"

#include <algorithm>
#include <limits>
#include <set>

namespace lumi {
namespace {

constexpr int kRaysAcross = 9;

/// Cameras that a face has when it lies between cameras.
std::size_t cameras_between(MeshConstruction construction) {
    const bool is_row =
        construction == MeshConstruction::kLine || construction == MeshConstruction::kPair;
    return is_row ? 2 : 3;
}

double to_nearest_other(const CameraMesh& mesh, const Eigen::Vector3d& place,
                        const CameraMesh::Vertex* self) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const CameraMesh::Vertex& other : mesh.vertices)
        if (&other != self) nearest = std::min(nearest, (other.position_in_world - place).norm());
    return nearest;
}

ViewPlace place_without_faces(const CameraMesh& mesh, const Eigen::Vector3d& eye) {
    double widest_gap = 0;
    for (const CameraMesh::Vertex& camera : mesh.vertices)
        widest_gap =
            std::max(widest_gap, to_nearest_other(mesh, camera.position_in_world, &camera));
    return to_nearest_other(mesh, eye, nullptr) <= widest_gap ? ViewPlace::kInterior
                                                              : ViewPlace::kBorder;
}

}  // namespace

ViewPlace place_of_view(const CameraMesh& mesh, const Camera& camera,
                        const Rigid3& cam_from_world) {
    const Eigen::Vector3d eye = centre_in_world(cam_from_world);
    if (mesh.faces.empty()) return place_without_faces(mesh, eye);
    int interior = 0;
    for (int row = 0; row < kRaysAcross; ++row) {
        for (int column = 0; column < kRaysAcross; ++column) {
            const Eigen::Vector2d pixel((column + 0.5) * camera.width_px / kRaysAcross,
                                        (row + 0.5) * camera.height_px / kRaysAcross);
            const Eigen::Vector3d direction =
                cam_from_world.rotation.conjugate() * unproject(camera, pixel);
            const auto weights = weights_of_ray(mesh, eye, direction.normalized());
            if (!weights) continue;
            const std::set<int> cameras(weights->view_indices.begin(), weights->view_indices.end());
            if (cameras.size() >= cameras_between(mesh.construction)) ++interior;
        }
    }
    return 2 * interior >= kRaysAcross * kRaysAcross ? ViewPlace::kInterior : ViewPlace::kBorder;
}

}  // namespace lumi
