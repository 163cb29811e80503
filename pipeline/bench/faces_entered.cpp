#include "pipeline/bench/faces_entered.h"

#include <algorithm>

namespace lumi {

int faces_entered(const CameraMesh& mesh, const Eigen::Vector3d& point,
                  const Eigen::Vector3d& direction) {
    return static_cast<int>(
        std::count_if(mesh.faces.begin(), mesh.faces.end(), [&](const CameraMesh::Face& face) {
            const Eigen::Vector3d sides = side_products(mesh, face, point, direction);
            return sides.minCoeff() >= 0 && sides.sum() > 0;
        }));
}

}  // namespace lumi
