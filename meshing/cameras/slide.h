#pragma once

#include <Eigen/Core>
#include <vector>

#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// What it took to bring the scene into the kernel by moving vertices.
struct SlideReport {
    bool reached = false;  ///< Otherwise the mesh is as it was.
    int cameras_slid = 0;
    double largest_share = 0.0;  ///< Of a camera's distance from the scene centre.
    double rms_share = 0.0;      ///< Over all cameras.
};

struct SlideOptions {
    double room = 0.02;            ///< The scene is grown by this share about the scene centre.
    double longest_slide = 0.5;    ///< A camera moves by at most this share of its distance.
    double virtual_weight = 1e-6;  ///< What moving a virtual vertex costs against a camera.
};

/// Moves vertices along their directions from the scene centre, as little as possible, so that the
/// scene's hull comes to lie in the kernel: the last repair, for the weights of a camera that was
/// slid are no longer 1 on all of its own rays (see epipole_loss.h). Photographs are looked
/// up from where they were taken all the same.
///
/// With inverse distances q = 1 / rho and unit directions d, the plane of a face is m . (x - o) = 1
/// with m = [d_i d_j d_k]^-T q_f, so that "X is on the inner side" is linear in q. What is solved
/// is
///     min sum rho_i^4 (q_i' - q_i)^2   subject to   [d_i d_j d_k]^-1 (X_s - o) . q'_f <= 1
/// over the faces f and the hull's corners X_s, by dual coordinate ascent over the constraints that
/// are found violated (Hildreth 1957). In strips the pairs of vertices move within the plane that
/// the strip's normal is perpendicular to.
[[nodiscard]] SlideReport slide_into_kernel(CameraMesh& mesh,
                                            const std::vector<Eigen::Vector3d>& scene_hull_in_world,
                                            const SlideOptions& options = {});

}  // namespace lumi
