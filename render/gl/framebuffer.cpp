#include "render/gl/framebuffer.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <cassert>
#include <string>
#include <utility>

#include "calib/work/error.h"
#include "render/gl/capabilities.h"

namespace lumi {
namespace {

/// That any GL can draw at once.
constexpr int kMostOutputs = 4;

unsigned new_framebuffer() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
}

unsigned new_renderbuffer() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
}

void require_within_limits(int width_px, int height_px) {
    const Capabilities capabilities = query_capabilities();
    if (std::max(width_px, height_px) <= capabilities.max_renderbuffer_size_px) return;
    throw Error(ErrorKind::kResources, "E-GL-LIMIT",
                "no frame of " + std::to_string(width_px) + "x" + std::to_string(height_px) + ": " +
                    capabilities.description + " draws " +
                    std::to_string(capabilities.max_renderbuffer_size_px) + " pixels a side",
                "draw a smaller frame");
}

}  // namespace

void delete_framebuffer(unsigned name) { glDeleteFramebuffers(1, &name); }
void delete_renderbuffer(unsigned name) { glDeleteRenderbuffers(1, &name); }

Framebuffer::Framebuffer() : name_(new_framebuffer()) {}

void Framebuffer::bind() const { glBindFramebuffer(GL_FRAMEBUFFER, name_.get()); }

void Framebuffer::attach_depth_layer(const TextureArray& depth, int layer) {
    bind();
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, depth.name(), 0, layer);
    const GLenum none = GL_NONE;
    glDrawBuffers(1, &none);
    glReadBuffer(GL_NONE);
    require_complete();
}

void Framebuffer::attach_color_layer(const TextureArray& color, int layer, int level) {
    bind();
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, color.name(), level, layer);
    require_complete();
}

void Framebuffer::attach_color_layers(const TextureArray& color) {
    assert(color.layers() <= kMostOutputs);
    bind();
    std::vector<GLenum> outputs;
    for (int layer = 0; layer < color.layers(); ++layer) {
        outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(layer));
        glFramebufferTextureLayer(GL_FRAMEBUFFER, outputs.back(), color.name(), 0, layer);
    }
    glDrawBuffers(static_cast<GLsizei>(outputs.size()), outputs.data());
    require_complete();
}

void Framebuffer::attach_color(int width_px, int height_px) {
    require_within_limits(width_px, height_px);
    bind();
    ObjectName<delete_renderbuffer> color(new_renderbuffer());
    glBindRenderbuffer(GL_RENDERBUFFER, color.get());
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_px, height_px);
    attach_renderbuffer(color.get());
    try {
        require_complete();
    } catch (const Error&) {
        attach_renderbuffer(color_.get());
        throw;
    }
    color_ = std::move(color);
}

void Framebuffer::attach_renderbuffer(unsigned name) const {
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, name);
}

std::vector<unsigned char> Framebuffer::read_rgba_bottom_up(int width_px, int height_px) const {
    std::vector<unsigned char> rgba(4 * static_cast<std::size_t>(width_px) *
                                    static_cast<std::size_t>(height_px));
    bind();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width_px, height_px, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    return rgba;
}

void Framebuffer::copy_to_window(int width_px, int height_px, int window_width_px,
                                 int window_height_px) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, name_.get());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    const bool is_whole = width_px == window_width_px && height_px == window_height_px;
    glBlitFramebuffer(0, 0, width_px, height_px, 0, 0, window_width_px, window_height_px,
                      GL_COLOR_BUFFER_BIT, is_whole ? GL_NEAREST : GL_LINEAR);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

void Framebuffer::require_complete() const {
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    if (status == GL_FRAMEBUFFER_COMPLETE) return;
    throw Error(ErrorKind::kResources, "E-GL-LIMIT",
                "this GL cannot draw into a framebuffer of the size or format asked for (status " +
                    std::to_string(status) + ")",
                "draw a smaller frame");
}

FramebufferBindingKeeper::FramebufferBindingKeeper() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_name_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_name_);
}

FramebufferBindingKeeper::~FramebufferBindingKeeper() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_name_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_name_));
}

}  // namespace lumi
