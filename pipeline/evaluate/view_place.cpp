#include "pipeline/evaluate/view_place.h"

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

}  // namespace

ViewPlace place_of_view(const CameraMesh& mesh, const Camera& camera,
                        const Rigid3& cam_from_world) {
    const Eigen::Vector3d eye = centre_in_world(cam_from_world);
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
