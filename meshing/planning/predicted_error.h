#pragma once

#include <Eigen/Core>
#include <vector>

#include "calib/capture/capture.h"
#include "meshing/cameras/camera_star.h"

namespace lumi {

/// How well the depth of a scene is known, and what a pixel is worth.
struct DepthUncertainty {
    double focal_length_px = 0.0;  ///< Median over the views.
    /// Standard deviation of inverse depth, per world unit: the median over the scene's points of
    /// error / (focal length * baseline of the track). Of 0.5 px between neighbouring cameras where
    /// nothing is known of the points.
    double inverse_depth = 0.0;
};

[[nodiscard]] DepthUncertainty depth_uncertainty(const Capture& capture,
                                                 const std::vector<int>& view_indices,
                                                 const CameraStar& star);

/// A place between cameras where the picture is predicted to be worst.
struct Hole {
    Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();  ///< From the scene centre, length one.
    double distance = 0.0;    ///< Of the cameras around it from the scene centre, their mean.
    double radius_rad = 0.0;  ///< The angle to the nearest camera.
    /// Focal length * uncertainty of inverse depth * distance across the hole: by how much what two
    /// of its cameras show of one point falls apart.
    double error_px = 0.0;
    std::vector<int> view_indices;  ///< Of the cameras around it.
};

/// The holes between the cameras, the worst first: one for each triangle of their directions, or
/// each pair of neighbours where they stand in a row. A triangle's hole is the centre of its
/// circumscribed cap, or, where that lies beyond its longest edge, the middle of the edge. Caps
/// wider than 75 degrees are the far side of a capture, which nobody meant to photograph.
[[nodiscard]] std::vector<Hole> holes_between(const CameraStar& star, bool in_a_row,
                                              const Eigen::Vector3d& row_normal,
                                              const DepthUncertainty& uncertainty);

}  // namespace lumi
