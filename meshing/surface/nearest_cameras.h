#pragma once

#include <Eigen/Core>
#include <set>
#include <vector>

#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// What a share of an eye's picture is blended from.
struct EyeBlend {
    RayWeights weights;
    double share = 1.0;
};

/// Of a mesh without faces, whose weights are those of the eye and its optical axis: the three
/// cameras nearest to the eye, by how much nearer than the fourth they are (Buehler et al.,
/// SIGGRAPH 2001, for the eye as a whole). A camera that looks another way than the eye counts as
/// farther off by the cosine between both, so that of cameras that turned in one place those are
/// taken that see what the eye does. Where the next camera is nearly as near, a share of the
/// picture is blended from it instead (gradual_choice.h), so that none is exchanged all at once:
/// shares, which sum to 1, and weights are continuous in the eye and `line_of_sight` (of length
/// one), but where nine cameras or more are nearly as near as the third, and at a place where four
/// stand. A camera's own eye has its picture but for some thousandths, by which the next ones show
/// what it does not, unless another stands as near. The mesh must have a vertex.
[[nodiscard]] std::vector<EyeBlend> blends_of_eye(const CameraMesh& mesh,
                                                  const Eigen::Vector3d& eye_in_world,
                                                  const Eigen::Vector3d& line_of_sight);

/// Those of the largest share.
[[nodiscard]] RayWeights weights_of_eye(const CameraMesh& mesh, const Eigen::Vector3d& eye_in_world,
                                        const Eigen::Vector3d& line_of_sight);

/// Of each view the three that come next to it by the same measure, and those to which it does.
[[nodiscard]] std::vector<std::set<int>> nearest_views(const CameraMesh& mesh,
                                                       std::size_t view_count);

}  // namespace lumi
