#include "render/gl/vertex_buffer.h"

#include <epoxy/gl.h>

#include <utility>

namespace lumi {

namespace {

unsigned new_buffer() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
}

/// Vertex arrays remember what is bound to GL_ELEMENT_ARRAY_BUFFER; this is bound to none of them.
void fill(unsigned name, const void* data, std::size_t bytes) {
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), data, GL_DYNAMIC_DRAW);
}

}  // namespace

void delete_buffer(unsigned name) { glDeleteBuffers(1, &name); }

VertexBuffer::VertexBuffer(std::vector<VertexAttribute> attributes)
    : attributes_(std::move(attributes)),
      vertices_(new_buffer()),
      indices_(new_buffer()),
      array_(array_of_current_context()) {}

void VertexBuffer::upload(const std::vector<float>& vertices,
                          const std::vector<std::uint32_t>& indices) {
    upload(vertices.data(), vertices.size() * sizeof(float), indices);
}

void VertexBuffer::upload(const void* vertices, std::size_t bytes,
                          const std::vector<std::uint32_t>& indices) {
    fill(vertices_.get(), vertices, bytes);
    fill(indices_.get(), indices.data(), indices.size() * sizeof(std::uint32_t));
}

VertexArray VertexBuffer::array_of_current_context() const {
    return {attributes_, vertices_.get(), indices_.get()};
}

}  // namespace lumi
