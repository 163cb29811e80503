#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "calib/work/config_section.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// How the camera mesh is built.
struct CameraMeshOptions {
    std::string construction = "auto";  ///< "auto", "closed", "open", "line" or "nearest".
    /// "star": every camera is a vertex; "convex": the paper's mesh, without the cameras within.
    std::string shape = "star";
    bool repair =
        true;  ///< Flip edges and slide vertices when the scene reaches out of the kernel.
    bool shells = true;  ///< Close-ups refine what they see in shells of their own; not if convex.
};

void validate(const CameraMeshOptions& options);
[[nodiscard]] CameraMeshOptions read_camera_mesh_options(const ConfigSection& section);

/// What speaks for the mesh.
struct CameraMeshEvidence {
    int cameras_total = 0;
    int cameras_kept = 0;  ///< Vertices of the mesh or of one of its shells.
    int close_ups = 0;     ///< Those of shells.
    int shells = 0;
    double kernel_radius_over_scene_radius = 0.0;  ///< >= 1: every ray crosses exactly one face.
    int faces_with_scene_outside = 0;              ///< Faces whose plane cuts the scene.
    double scene_share_in_kernel = 0.0;            ///< Of the scene's points.
    int edges_flipped = 0;                         ///< The first repair; costs nothing.
    int cameras_slid = 0;                          ///< The second; weights only.
    double largest_slide_share = 0.0;              ///< Of a camera's distance from the centre.
    double rms_slide_share = 0.0;
    /// Of the weight on cameras' rays to the scene, what these cameras have (own_rays.h).
    double own_ray_share = 1.0;
    /// Of its own weight that a slid camera loses on its rays to the scene.
    double worst_epipole_loss = 0.0;
    double rms_epipole_loss = 0.0;         ///< Over all cameras, each with its worst ray.
    double epipole_loss_bound = 0.0;       ///< What the worst may come to (epipole_loss.h).
    double epipole_loss_over_bound = 0.0;  ///< The largest share of its bound: at most 1.
    std::string explanation;               ///< One sentence: which construction, and why.
};

struct BuiltCameraMesh {
    CameraMesh mesh;
    CameraMeshEvidence evidence;
};

/// The kernel-star camera mesh over the given views of the capture (indices into capture.views):
/// spherical hull of the directions from a scene centre, so that every camera is a vertex. Where
/// the scene reaches out of the kernel, edges are flipped, and then vertices slid, until it does
/// not: the whole scene if that can be had, else the largest inner part of it. Close-ups that see a
/// part of the scene only are no vertices of it, but of shells (close_ups.h). Where cameras walk
/// forward, or a surface would not lie between them and the scene (preconditions.h), all are
/// vertices and there are no faces; but not because of few strays (stray_cameras.h), which are left
/// out. Vertices name views by their index in capture.views. Throws Error (E-MESH-NOVIEW) when
/// `view_indices` is empty.
[[nodiscard]] BuiltCameraMesh build_camera_mesh(const Capture& capture,
                                                const std::vector<int>& view_indices,
                                                const CameraMeshOptions& options);

}  // namespace lumi
