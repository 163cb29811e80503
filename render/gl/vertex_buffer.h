#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/gl/object_name.h"

namespace lumi {

void delete_buffer(unsigned name);
void delete_vertex_array(unsigned name);

/// One attribute of an interleaved vertex of floats.
struct VertexAttribute {
    unsigned location = 0;
    int components = 0;
};

/// Interleaved float vertices, their layout, and indices of triangles.
class VertexBuffer {
 public:
    VertexBuffer() = default;
    /// The attributes follow each other in a vertex, in this order and without gaps.
    explicit VertexBuffer(const std::vector<VertexAttribute>& attributes);

    /// Replaces the content. `vertices` holds whole vertices.
    void upload(const std::vector<float>& vertices, const std::vector<std::uint32_t>& indices);
    /// The same from vertices that lie in memory as the attributes do.
    void upload(const void* vertices, std::size_t bytes, const std::vector<std::uint32_t>& indices);
    /// Draws triangles from `first` for `count` indices.
    void draw(std::size_t first, std::size_t count) const;
    /// Draws lines, `count` / 2 of them, each between two indices.
    void draw_lines(std::size_t count) const;

 private:
    ObjectName<delete_vertex_array> vertex_array_;
    ObjectName<delete_buffer> vertices_;
    ObjectName<delete_buffer> indices_;
};

}  // namespace lumi
