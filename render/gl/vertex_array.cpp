#include "render/gl/vertex_array.h"

#include <epoxy/gl.h>

#include <cstdint>

namespace lumi {
namespace {

unsigned new_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
}

/// GL wants byte offsets into a buffer as pointers.
const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

void delete_vertex_array(unsigned name) { glDeleteVertexArrays(1, &name); }

VertexArray::VertexArray(const std::vector<VertexAttribute>& attributes, unsigned vertices,
                         unsigned indices)
    : name_(new_vertex_array()) {
    int components = 0;
    for (const VertexAttribute& attribute : attributes) components += attribute.components;
    const std::size_t stride = sizeof(float) * static_cast<std::size_t>(components);
    glBindVertexArray(name_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
    std::size_t offset = 0;
    for (const VertexAttribute& attribute : attributes) {
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(stride), byte_offset(offset));
        offset += sizeof(float) * static_cast<std::size_t>(attribute.components);
    }
    glBindVertexArray(0);
}

void VertexArray::draw(std::size_t first, std::size_t count) const {
    if (count == 0) return;
    glBindVertexArray(name_.get());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   byte_offset(first * sizeof(std::uint32_t)));
    glBindVertexArray(0);
}

void VertexArray::draw_lines(std::size_t count) const {
    if (count == 0) return;
    glBindVertexArray(name_.get());
    glDrawElements(GL_LINES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, byte_offset(0));
    glBindVertexArray(0);
}

}  // namespace lumi
