#pragma once

#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/config_section.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// How the camera mesh is built.
struct CameraMeshOptions {
    std::string construction = "auto";  ///< "auto", or "closed", "open", "line".
};

void validate(const CameraMeshOptions& options);
[[nodiscard]] CameraMeshOptions read_camera_mesh_options(const ConfigSection& section);

/// What speaks for the mesh.
struct CameraMeshEvidence {
    int cameras_total = 0;
    int cameras_kept = 0;
    double kernel_radius_over_scene_radius = 0.0;  ///< >= 1: every ray crosses exactly one face.
    int faces_with_scene_outside = 0;              ///< Faces whose plane cuts the scene.
    std::string explanation;                       ///< One sentence: which construction, and why.
};

struct BuiltCameraMesh {
    CameraMesh mesh;
    CameraMeshEvidence evidence;
};

/// The kernel-star camera mesh over the given views of the capture (indices into capture.views):
/// spherical hull of the directions from a scene centre, so that every camera is a vertex. Vertices
/// name views by their index in capture.views. Throws Error (E-MESH-NOVIEW) when `view_indices` is
/// empty.
[[nodiscard]] BuiltCameraMesh build_camera_mesh(const Capture& capture,
                                                const std::vector<int>& view_indices,
                                                const CameraMeshOptions& options);

}  // namespace lumi
