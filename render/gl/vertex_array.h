#pragma once

#include <cstddef>
#include <vector>

#include "render/gl/object_name.h"

namespace lumi {

void delete_vertex_array(unsigned name);

/// One attribute of an interleaved vertex of floats.
struct VertexAttribute {
    unsigned location = 0;
    int components = 0;
};

/// How a context reads triangles from buffers. Contexts share the buffers, but not this.
class VertexArray {
 public:
    VertexArray() = default;
    /// The attributes follow each other in a vertex, in this order and without gaps. The buffers,
    /// one of vertices and one of 32-bit indices, must stay.
    VertexArray(const std::vector<VertexAttribute>& attributes, unsigned vertices,
                unsigned indices);

    /// Draws triangles from `first` for `count` indices.
    void draw(std::size_t first, std::size_t count) const;
    /// Draws lines, `count` / 2 of them, each between two indices.
    void draw_lines(std::size_t count) const;

 private:
    ObjectName<delete_vertex_array> name_;
};

}  // namespace lumi
