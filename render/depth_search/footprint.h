#pragma once

#include <Eigen/Core>
#include <array>

#include "render/depth_search/tiled_depth.h"

namespace lumi {

/// A flat triangle of the scene as a view sees it.
struct Footprint {
    std::array<Eigen::Vector2d, 3> corners;  ///< In pixels of the photograph or samples of its map.
    Eigen::Vector3d inverse_depths;          ///< Of the corners, in the view.
};

/// Whether the view has seen something within the triangle that lies before it by more than
/// `margin`, of inverse depth. Within a sample and a half of its edges nothing is looked for: there
/// outlines are not known so well. The triangle's corners are in samples.
[[nodiscard]] bool is_anything_before(const Footprint& triangle, double margin,
                                      const TiledDepth& depth);

}  // namespace lumi
