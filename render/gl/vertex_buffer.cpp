#include "render/gl/vertex_buffer.h"

#include <epoxy/gl.h>

#include <cassert>

#include "render/gl/draw_queries.h"

namespace lumi {

namespace {

unsigned new_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
}

unsigned new_vertex_array() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
}

/// GL wants byte offsets into a buffer as pointers.
const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

}  // namespace

void delete_buffer(unsigned name) { glDeleteBuffers(1, &name); }
void delete_vertex_array(unsigned name) { glDeleteVertexArrays(1, &name); }

VertexBuffer::VertexBuffer(const std::vector<VertexAttribute>& attributes)
    : vertex_array_(new_vertex_array()), vertices_(new_buffer()), indices_(new_buffer()) {
    int components = 0;
    for (const VertexAttribute& attribute : attributes) components += attribute.components;
    const std::size_t stride = sizeof(float) * static_cast<std::size_t>(components);
    glBindVertexArray(vertex_array_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.get());
    std::size_t offset = 0;
    for (const VertexAttribute& attribute : attributes) {
        glEnableVertexAttribArray(attribute.location);
        glVertexAttribPointer(attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                              static_cast<GLsizei>(stride), byte_offset(offset));
        offset += sizeof(float) * static_cast<std::size_t>(attribute.components);
    }
    glBindVertexArray(0);
}

void VertexBuffer::upload(const std::vector<float>& vertices,
                          const std::vector<std::uint32_t>& indices) {
    upload(vertices.data(), vertices.size() * sizeof(float), indices);
}

void VertexBuffer::upload(const void* vertices, std::size_t bytes,
                          const std::vector<std::uint32_t>& indices) {
    glBindVertexArray(vertex_array_.get());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.get());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), vertices, GL_DYNAMIC_DRAW);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data(),
                 GL_DYNAMIC_DRAW);
    glBindVertexArray(0);
    count_uploaded(bytes + indices.size() * sizeof(std::uint32_t));
}

void VertexBuffer::draw(std::size_t first, std::size_t count) const {
    if (count == 0) return;
    glBindVertexArray(vertex_array_.get());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(count), GL_UNSIGNED_INT,
                   byte_offset(first * sizeof(std::uint32_t)));
    glBindVertexArray(0);
}

void VertexBuffer::draw_lines(std::size_t count) const {
    if (count == 0) return;
    glBindVertexArray(vertex_array_.get());
    glDrawElements(GL_LINES, static_cast<GLsizei>(count), GL_UNSIGNED_INT, byte_offset(0));
    glBindVertexArray(0);
}

}  // namespace lumi
