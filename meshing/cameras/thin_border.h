#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace lumi {

/// Takes thin triangles off the border until there is none whose altitude over a border edge is
/// below `thin_altitude` of that edge: what is between three cameras that stand nearly in one line
/// is no surface, and its plane may point anywhere. The camera at its tip comes to stand on the
/// border. A triangle stays when its tip already does.
void peel_thin_border(const std::vector<Eigen::Vector3d>& directions, double thin_altitude,
                      std::vector<std::array<int, 3>>& faces);

}  // namespace lumi
