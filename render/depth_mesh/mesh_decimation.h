#pragma once

#include "render/lumigraph/depth_mesh.h"

namespace lumi {

/// How far a mesh may depart from the one it is made of, in pixels of the photograph.
struct DecimationOptions {
    double max_error_px = 0.1;  ///< Of disparity, at vertices that are left out, and on sides.
    /// So many times more, and of where surfaces end, where nothing around was seen.
    double guess_error_ratio = 1.0;
    double check_every_px = 2.0;  ///< On sides, and at their middles.
    double max_tear_px = 0.5;     ///< Of where surfaces end.
    /// Of where what was seen goes over into what is filled, the surface being the same.
    double max_kind_border_px = 1.0;
};

/// The mesh with fewer triangles: vertices are drawn into a neighbour (half-edge collapse; Hoppe
/// 1996) as long as every vertex that is gone, and points on the sides that are, keep to the error.
/// Borders between kinds and at tears become lines with fewer corners; they stay joined where they
/// were. No triangle turns over in the photograph, and the corners of the photograph stay.
/// `disparity_px` turns inverse depth into pixels.
[[nodiscard]] DepthMesh decimated(const DepthMesh& mesh, double disparity_px,
                                  const DecimationOptions& options);

}  // namespace lumi
