#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "calib/capture/camera.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// How far a piece of depth can be relied on; where pieces compete, the first kind wins.
enum class DepthKind : int {
    kSeen = 0,       ///< Measured by the view.
    kFilled = 1,     ///< A fill for drawing.
    kStretched = 2,  ///< Spans a tear between foreground and background: the last resort.
};
inline constexpr int kDepthKinds = 3;

struct DepthMeshOptions {
    double max_error_px = 0.1;         ///< The mesh follows the depth map this closely.
    double max_coarse_error_px = 0.4;  ///< Allowed instead when there would be too many triangles.
    std::size_t max_triangles = 8'000;
    /// Where a depth map would need more than this even so, its samples tell noise: pairs of rows
    /// and of columns are drawn as one, and the mesh follows these less closely.
    double max_triangles_per_sample = 0.25;
    double max_noisy_error_px = 1.6;
    /// Vertices are left out as long as that adds no more than this share of the error
    /// (mesh_decimation.h); 0: none is.
    double decimated_share = 0.5;
};

/// A view's depth map as triangles over its photograph.
///
/// Vertices are (x, y) in pixels of the photograph and the inverse depth there, which is affine in
/// the picture for a plane: planes need few triangles. Those seen or filled reach half a sample
/// beyond the last of each surface, those stretched cover the rest: the whole photograph.
struct DepthMesh {
    std::vector<Eigen::Vector3f> vertices;
    std::vector<std::uint32_t> indices;  ///< Three a triangle, sorted by kind.
    /// Triangles of kind k are indices[kind_begin[k]] up to indices[kind_begin[k + 1]].
    std::array<std::size_t, kDepthKinds + 1> kind_begin{};
};

/// The coarsest right-triangulated irregular network (Evans, Kirkpatrick, Townsend 2001) that stays
/// within the error: without cracks, and down to single samples along tears and at the edges of
/// what was seen; then without the vertices that it keeps to the error without. `disparity_px`
/// turns inverse depth into pixels (view_geometry.h).
[[nodiscard]] DepthMesh triangulate(const DepthMap& depth, const Camera& camera,
                                    double disparity_px, const DepthMeshOptions& options = {});

}  // namespace lumi
