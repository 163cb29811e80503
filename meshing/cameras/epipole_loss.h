#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// What slid cameras leave of their own weight to others, on their rays to the scene. For each
/// camera its worst ray counts.
struct EpipoleLoss {
    double worst = 0.0;        ///< 1 - weight; 0 unless a camera was slid, up to rounding.
    double rms = 0.0;          ///< Over all cameras of the mesh.
    double worst_bound = 0.0;  ///< The largest `epipole_loss_bound`.
    /// The largest share of its bound that any camera's loss comes to: at most 1.
    double worst_over_bound = 0.0;
};

/// Measured on the rays between each camera and the corners of the scene's hull. `centre_of_view`
/// gives each view's true centre.
[[nodiscard]] EpipoleLoss epipole_loss(
    const CameraMesh& mesh, const std::function<Eigen::Vector3d(int view_index)>& centre_of_view,
    const std::vector<Eigen::Vector3d>& scene_hull_in_world);

/// What a slide of the vertex from `true_centre` along its direction from the scene centre costs at
/// most, on rays to a ball of radius r about the scene centre:
///     1 - w <= s r / (rho h cos(tilt + alpha)),  sin alpha = r / rho,
/// with s the slide, rho the lesser distance before and after it, h the altitude of a face at the
/// vertex and `tilt` the angle of that face's normal to the vertex's direction; the worst face
/// counts, and 1 is the most. (By the law of sines in the triangle of the ray, the direction and
/// the face. For faces perpendicular to the direction it is s r / (h sqrt(rho^2 - r^2)).)
[[nodiscard]] double epipole_loss_bound(const CameraMesh& mesh, std::size_t vertex_index,
                                        const std::vector<std::size_t>& faces_at_vertex,
                                        const Eigen::Vector3d& true_centre, double scene_radius);

}  // namespace lumi
