#pragma once

#include <string>

#include "meshing/cameras/arrangement.h"
#include "meshing/cameras/camera_mesh_builder.h"

namespace lumi {

/// One sentence on a mesh, from its arrangement and the figures of its evidence: "closed: the
/// cameras surround the scene ...; 48 of 48 cameras are vertices of the mesh; ...".
[[nodiscard]] std::string mesh_explanation(const CameraMesh& mesh, const Arrangement& arrangement,
                                           bool convex, bool has_scene,
                                           const CameraMeshEvidence& evidence);

}  // namespace lumi
