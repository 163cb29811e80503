#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumi {

/// How far a piece of depth can be relied on; where pieces compete, the first kind wins.
enum class DepthKind : int {
    kSeen = 0,       ///< Measured by the view.
    kFilled = 1,     ///< A fill for drawing.
    kStretched = 2,  ///< Spans a tear between foreground and background: the last resort.
};
inline constexpr int kDepthKinds = 3;

/// How far depth meshes may be from depth maps whose samples tell noise
/// (DepthMeshOptions::max_noisy_error_px): the default where photographs were not asked, and its
/// bounds.
inline constexpr double kNoisyDepthError_px = 1.6;
inline constexpr double kLeastNoisyDepthError_px = 0.1;
inline constexpr double kMostNoisyDepthError_px = 10.0;

/// A view's depth map as triangles over its photograph.
///
/// Vertices are (x, y) in pixels of the photograph and the inverse depth there, which is affine in
/// the picture for a plane: planes need few triangles. Those seen or filled reach half a sample
/// beyond the last of each surface; those stretched cover the rest of the photograph, but for what
/// ends in infinity: from a little aside it would cover half of the picture.
struct DepthMesh {
    std::vector<Eigen::Vector3f> vertices;
    std::vector<std::uint32_t> indices;  ///< Three a triangle, sorted by kind.
    /// Triangles of kind k are indices[kind_begin[k]] up to indices[kind_begin[k + 1]].
    std::array<std::size_t, kDepthKinds + 1> kind_begin{};

    int columns = 0;  ///< Of the samples that it was made of.
    int rows = 0;     ///< The same.
    /// How closely it was to follow the depth map; missed where that takes too many triangles.
    double wanted_error_px = 0.0;
    double error_px = 0.0;      ///< How closely it does, where the view saw the scene.
    double disparity_px = 0.0;  ///< Of a unit of inverse depth (view_geometry.h).
};

}  // namespace lumi
