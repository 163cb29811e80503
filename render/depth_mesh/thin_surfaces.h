#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "render/depth_mesh/depth_triangulation.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What a view has seen that stands before all around it and is narrower than the triangles of the
/// mode `adaptive` are long: bars, cables, tips, leaves.
struct ThinSurfaces {
    std::vector<Eigen::Vector3f> vertices;  ///< (x, y) in pixels of the photograph, inverse depth.
    std::vector<std::uint32_t> indices;     ///< Three a triangle.
};

/// The part of a view's depth mesh (DepthMesh) in which something seen stands out of what is around
/// it: the white top-hat of its inverse depth (Meyer, Contrast feature extraction, 1979), which is
/// what an opening by a square takes away. With fewer triangles than depth is drawn with, as
/// photographs are looked up in the view itself. `disparity_px` is that of a unit of inverse depth
/// (view_geometry.h), `options` are those of its mesh. Empty where nothing stands out, and without
/// depth.
[[nodiscard]] ThinSurfaces thin_surfaces(const LumigraphView& view, double disparity_px,
                                         const DepthMeshOptions& options);

}  // namespace lumi
