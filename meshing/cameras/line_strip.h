#pragma once

#include <Eigen/Core>

#include "meshing/cameras/camera_star.h"
#include "meshing/surface/camera_mesh.h"

namespace lumi {

/// What a strip could hold.
struct LineStrip {
    CameraMesh mesh;
    bool closed_ring = false;
    int hidden_cameras = 0;  ///< Left out: another camera stands at the same azimuth.
};

/// The camera mesh of a row, arc or ring: each camera is doubled to its centre +- `length` times
/// `normal` (length one), neighbours in azimuth about the normal span quadrilaterals. Weights then
/// change along the row only, as the limit of triangles stretched to infinity, and are 1 on the
/// whole line through a camera along the normal. A row or arc goes on beyond both ends by virtual
/// vertices of the end cameras; a ring, whose widest gap in azimuth is at most 60 degrees or three
/// usual ones (never 150), is closed. Of cameras at the same azimuth (within 1e-6 radians) the one
/// nearest to the median distance is kept.
[[nodiscard]] LineStrip build_line_strip(const CameraStar& star, const Eigen::Vector3d& normal,
                                         double length);

}  // namespace lumi
