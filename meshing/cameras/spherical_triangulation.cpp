#include "meshing/cameras/spherical_triangulation.h"

#include "meshing/cameras/convex_hull.h"

namespace lumi {

std::vector<std::array<int, 3>> spherical_triangulation(
    const std::vector<Eigen::Vector3d>& directions) {
    return convex_hull_faces(directions);
}

}  // namespace lumi
