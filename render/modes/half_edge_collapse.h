#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/lumigraph/depth_mesh.h"
#include "render/modes/mesh_decimation.h"

namespace lumi {

/// (x, y) of the photograph and the disparity, all in pixels.
using DisparityPoint = Eigen::Vector3f;
using PointIndex = std::uint32_t;
constexpr PointIndex kNoPoint = 0xffffffffU;

/// A triangle of a mesh whose vertices are drawn into one another.
struct CollapsingTriangle {
    std::array<PointIndex, 3> corners{};
    DepthKind kind = DepthKind::kSeen;
    bool is_alive = true;
    PointIndex first_point = kNoPoint;  ///< Of those left out that lie in it, as a chain.
    std::array<float, 3> moved_px{};    ///< How far the side from corner i on is from where it was.

    /// 3 where the vertex is no corner.
    [[nodiscard]] std::size_t place_of(PointIndex vertex) const {
        return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : corners[2] == vertex ? 2 : 3;
    }
};

/// Draws vertices into neighbours as long as the options allow (mesh_decimation.h). Triangles that
/// are gone are no longer alive; `points` keeps its order.
void collapse_half_edges(const std::vector<DisparityPoint>& points,
                         std::vector<CollapsingTriangle>& triangles,
                         const DecimationOptions& options);

}  // namespace lumi
