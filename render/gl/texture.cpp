#include "render/gl/texture.h"

#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <vector>

#include "calib/work/error.h"
#include "render/gl/capabilities.h"
#include "render/gl/draw_queries.h"
#include "render/gl/framebuffer.h"

namespace lumi {

namespace {

struct GlFormat {
    GLenum internal;
    GLenum external;
    GLenum type;
};

GlFormat gl_format(TexelFormat format) {
    switch (format) {
        case TexelFormat::kColor:
            return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
        case TexelFormat::kFloat:
            return {GL_R32F, GL_RED, GL_FLOAT};
        case TexelFormat::kFourFloats:
            return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
        case TexelFormat::kDepth:
            return {GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT};
    }
    return {};
}

GLint gl_filter(TexelFilter filter) {
    return filter == TexelFilter::kLinear ? GL_LINEAR : GL_NEAREST;
}

unsigned new_texture() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
}

/// The first that GL has complained of since this was last asked; it forgets all of that.
GLenum take_gl_error() {
    const GLenum first = glGetError();
    for (GLenum next = first; next != GL_NO_ERROR;) next = glGetError();
    return first;
}

[[noreturn]] void refuse(const TextureArray& array, const std::string& reason) {
    throw Error(ErrorKind::kResources, "E-GL-LIMIT",
                "no texture of " + std::to_string(array.layers()) + " layers of " +
                    std::to_string(array.width_px()) + "x" + std::to_string(array.height_px()) +
                    ": " + reason,
                "draw smaller frames, make the package with a smaller [capture] max_width_px or "
                "with [package] max_views, or use another GL driver");
}

void require_within_limits(const TextureArray& array) {
    const Capabilities capabilities = query_capabilities();
    if (std::max(array.width_px(), array.height_px()) > capabilities.max_texture_size_px ||
        array.layers() > capabilities.max_array_layers)
        refuse(array, capabilities.description + " holds " +
                          std::to_string(capabilities.max_array_layers) + " layers of " +
                          std::to_string(capabilities.max_texture_size_px) + " pixels a side");
}

void require_no_error(const TextureArray& array) {
    const GLenum error = take_gl_error();
    if (error == GL_NO_ERROR) return;
    refuse(array, error == GL_OUT_OF_MEMORY
                      ? "the GL driver has no memory for it"
                      : "the GL driver refuses it (error " + std::to_string(error) + ")");
}

void clear_rectangle(int x, int y, int width_px, int height_px) {
    constexpr std::array<GLfloat, 4> kNothing{};
    glScissor(x, y, width_px, height_px);
    glClearBufferfv(GL_COLOR, 0, kNothing.data());
}

}  // namespace

void delete_texture(unsigned name) { glDeleteTextures(1, &name); }

TextureArray::TextureArray(TexelFormat format, TexelFilter filter, int width_px, int height_px,
                           int layers)
    : name_(new_texture()),
      width_px_(width_px),
      height_px_(height_px),
      layers_(layers),
      format_(format),
      filter_(filter) {
    require_within_limits(*this);
    take_gl_error();
    glBindTexture(GL_TEXTURE_2D_ARRAY, name_.get());
    const GLint mode = gl_filter(filter);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, mode);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, mode);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
    const GlFormat gl = gl_format(format);
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, static_cast<GLint>(gl.internal), width_px, height_px,
                 layers, 0, gl.external, gl.type, nullptr);
    require_no_error(*this);
}

void TextureArray::upload(int layer, const ColorImage& image) {
    assert(image.width() <= width_px_ && image.height() <= height_px_ && layer < layers_);
    std::vector<GLubyte> rgba;
    rgba.reserve(4 * image.pixels().size());
    for (const Rgb8& pixel : image.pixels())
        rgba.insert(rgba.end(), {pixel.r, pixel.g, pixel.b, GLubyte{255}});
    glBindTexture(GL_TEXTURE_2D_ARRAY, name_.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, image.width(), image.height(), 1, GL_RGBA,
                    GL_UNSIGNED_BYTE, rgba.data());
    count_uploaded(rgba.size());
}

void TextureArray::upload_rgba(int layer, const std::vector<unsigned char>& rgba) {
    assert(rgba.size() ==
           4 * static_cast<std::size_t>(width_px_) * static_cast<std::size_t>(height_px_));
    glBindTexture(GL_TEXTURE_2D_ARRAY, name_.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, width_px_, height_px_, 1, GL_RGBA,
                    GL_UNSIGNED_BYTE, rgba.data());
    count_uploaded(rgba.size());
}

void TextureArray::upload(int layer, const FloatImage& image) {
    assert(image.width() <= width_px_ && image.height() <= height_px_ && layer < layers_);
    glBindTexture(GL_TEXTURE_2D_ARRAY, name_.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer, image.width(), image.height(), 1, GL_RED,
                    GL_FLOAT, image.pixels().data());
    count_uploaded(image.pixels().size() * sizeof(float));
}

void TextureArray::upload(const std::vector<float>& texels) {
    assert(format_ == TexelFormat::kFourFloats && texels.size() * sizeof(float) == bytes());
    glBindTexture(GL_TEXTURE_2D_ARRAY, name_.get());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, width_px_, height_px_, layers_, GL_RGBA,
                    GL_FLOAT, texels.data());
    count_uploaded(texels.size() * sizeof(float));
}

std::size_t TextureArray::bytes() const {
    const std::size_t bytes_per_texel = format_ == TexelFormat::kFourFloats ? 16 : 4;
    return bytes_per_texel * static_cast<std::size_t>(width_px_) *
           static_cast<std::size_t>(height_px_) * static_cast<std::size_t>(layers_);
}

void TextureArray::bind(unsigned unit) const {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D_ARRAY, name_.get());
    // Looking the finest level up alone costs half as much.
    if (has_mip_levels_)
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, gl_filter(filter_));
}

void TextureArray::bind_mip_levels(unsigned unit) const {
    assert(has_mip_levels_);
    bind(unit);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
}

void TextureArray::make_mip_levels() {
    if (has_mip_levels_) return;
    constexpr GLint kAllLevels = 1000;
    take_gl_error();
    glBindTexture(GL_TEXTURE_2D_ARRAY, name_.get());
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, kAllLevels);
    glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
    require_no_error(*this);
    clear_borders_of_mip_levels();
    has_mip_levels_ = true;
}

void TextureArray::clear_borders_of_mip_levels() const {
    const FramebufferBindingKeeper keeper;
    Framebuffer framebuffer;
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    glEnable(GL_SCISSOR_TEST);
    for (int level = 1; std::max(width_px_, height_px_) >> level > 0; ++level) {
        const int width = std::max(1, width_px_ >> level);
        const int height = std::max(1, height_px_ >> level);
        for (int layer = 0; layer < layers_; ++layer) {
            framebuffer.attach_color_layer(*this, layer, level);
            clear_rectangle(0, 0, width, 1);
            clear_rectangle(0, height - 1, width, 1);
            clear_rectangle(0, 0, 1, height);
            clear_rectangle(width - 1, 0, 1, height);
        }
    }
    glDisable(GL_SCISSOR_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

}  // namespace lumi
