#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace lumi {

/// A picture of depth-buffer values in memory. Rows are counted from the bottom, as in OpenGL's
/// window coordinates.
struct DepthBuffer {
    std::span<float> texels;  ///< Row by row.
    int width = 0;
};

/// A part of a depth buffer.
struct DepthBufferBox {
    int begin_x = 0;
    int begin_y = 0;
    int end_x = 0;
    int end_y = 0;
};

/// A vertex of a depth mesh in an eye's window.
struct WindowVertex {
    float x = 0.0F;
    float y = 0.0F;
    float depth = 0.0F;  ///< 0 at the nearest that can be drawn, to 1 infinitely far away.
    /// Before the eye, not too near to be drawn, and not far beside the window: of others the
    /// numbers say nothing.
    bool is_ordinary = false;
};

/// Vertices as (x, y, inverse depth) in a view and the matrix that takes (x, y, 1, inverse depth)
/// to (X, Y, W, depth * W) in the window.
[[nodiscard]] WindowVertex window_vertex(const Eigen::Matrix4f& window_from_view,
                                         const Eigen::Vector3f& vertex);

/// A depth mesh as an eye sees it.
struct WindowMesh {
    const std::vector<Eigen::Vector3f>& vertices;  ///< In the view.
    const std::vector<std::uint32_t>& indices;
    const std::vector<WindowVertex>& in_window;
    Eigen::Matrix4f window_from_view;
};

/// Draws triangles of a depth mesh as OpenGL does with the depth test GL_LESS and back faces left
/// out: at the centre of each texel that one covers, the lesser depth stays, which is put into the
/// buffer's range from `range_begin` over `range_width`. Two triangles leave no gap on the side
/// that they share; a centre there may be of both.
void draw_depth_triangles(const WindowMesh& mesh, std::size_t first_index, std::size_t index_count,
                          float range_begin, float range_width, const DepthBufferBox& box,
                          const DepthBuffer& buffer);

}  // namespace lumi
