#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/gl/object_name.h"
#include "render/gl/vertex_array.h"

namespace lumi {

void delete_buffer(unsigned name);

/// Interleaved float vertices, their layout, and indices of triangles.
class VertexBuffer {
 public:
    VertexBuffer() = default;
    /// The attributes follow each other in a vertex, in this order and without gaps.
    explicit VertexBuffer(std::vector<VertexAttribute> attributes);

    /// Replaces the content. `vertices` holds whole vertices.
    void upload(const std::vector<float>& vertices, const std::vector<std::uint32_t>& indices);
    /// The same from vertices that lie in memory as the attributes do.
    void upload(const void* vertices, std::size_t bytes, const std::vector<std::uint32_t>& indices);
    /// Draws triangles from `first` for `count` indices.
    void draw(std::size_t first, std::size_t count) const { array_.draw(first, count); }
    /// Draws lines, `count` / 2 of them, each between two indices.
    void draw_lines(std::size_t count) const { array_.draw_lines(count); }
    /// For another context that shares buffers with the one in which this was made, and that is
    /// current now.
    [[nodiscard]] VertexArray array_of_current_context() const;

 private:
    std::vector<VertexAttribute> attributes_;
    ObjectName<delete_buffer> vertices_;
    ObjectName<delete_buffer> indices_;
    VertexArray array_;
};

}  // namespace lumi
