#pragma once

#include <string>

#include "meshing/cameras/arrangement.h"
#include "meshing/cameras/camera_mesh_builder.h"

namespace lumi {

/// What there is to say of a mesh beside its arrangement and the figures of its evidence.
struct MeshExplanationParts {
    bool is_convex = false;  ///< What was left out stands within the convex hull.
    bool has_scene = false;  ///< Points of the scene told how many of them lie in its kernel.
};

/// One sentence on a mesh, from its arrangement and the figures of its evidence: "closed: the
/// cameras surround the scene ...; 48 of 48 cameras are vertices of the mesh; ...".
[[nodiscard]] std::string mesh_explanation(const CameraMesh& mesh, const Arrangement& arrangement,
                                           const CameraMeshEvidence& evidence,
                                           const MeshExplanationParts& parts = {});

}  // namespace lumi
