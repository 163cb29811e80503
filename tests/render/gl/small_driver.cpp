#include "tests/render/gl/small_driver.h"

#include <epoxy/gl.h>

#include <algorithm>

#include "render/gl/headless_context.h"

namespace lumi {
namespace {

/// What libepoxy calls.
struct DriverFunctions {
    decltype(epoxy_glGetIntegerv) get_integer = nullptr;
    decltype(epoxy_glTexImage3D) make_texture = nullptr;
    decltype(epoxy_glRenderbufferStorage) make_raster = nullptr;
};

DriverFunctions real_driver;

struct DriverLimits {
    int side_px = 0;
    int layers = 0;
    int refused = 0;

    [[nodiscard]] bool hold(GLsizei width, GLsizei height, GLsizei wanted_layers) {
        const bool is_held = width <= side_px && height <= side_px && wanted_layers <= layers;
        if (!is_held) ++refused;
        return is_held;
    }
};

DriverLimits small_driver;

/// What no driver takes.
constexpr GLsizei kRefusedSize = -1;

void get_integer(GLenum name, GLint* value) {
    real_driver.get_integer(name, value);
    if (name == GL_MAX_TEXTURE_SIZE || name == GL_MAX_RENDERBUFFER_SIZE)
        *value = std::min(*value, small_driver.side_px);
    if (name == GL_MAX_ARRAY_TEXTURE_LAYERS) *value = std::min(*value, small_driver.layers);
}

void make_texture(GLenum target, GLint level, GLint internal, GLsizei width, GLsizei height,
                  GLsizei layers, GLint border, GLenum format, GLenum type, const void* texels) {
    real_driver.make_texture(target, level, internal,
                             small_driver.hold(width, height, layers) ? width : kRefusedSize,
                             height, layers, border, format, type, texels);
}

void make_raster(GLenum target, GLenum internal, GLsizei width, GLsizei height) {
    real_driver.make_raster(target, internal,
                            small_driver.hold(width, height, 1) ? width : kRefusedSize, height);
}

/// libepoxy finds a function when it is first called, and puts it in the place of what found it.
DriverFunctions found_functions() {
    const HeadlessContext context;
    GLint ignored = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &ignored);
    glTexImage3D(GL_NONE, 0, 0, 0, 0, 0, 0, GL_NONE, GL_NONE, nullptr);
    glRenderbufferStorage(GL_NONE, GL_NONE, 0, 0);
    return {epoxy_glGetIntegerv, epoxy_glTexImage3D, epoxy_glRenderbufferStorage};
}

}  // namespace

SmallDriver::SmallDriver(int most_side_px, int most_layers) {
    real_driver = found_functions();
    small_driver = {most_side_px, most_layers, 0};
    epoxy_glGetIntegerv = get_integer;
    epoxy_glTexImage3D = make_texture;
    epoxy_glRenderbufferStorage = make_raster;
}

SmallDriver::~SmallDriver() {
    epoxy_glGetIntegerv = real_driver.get_integer;
    epoxy_glTexImage3D = real_driver.make_texture;
    epoxy_glRenderbufferStorage = real_driver.make_raster;
}

int SmallDriver::refused() { return small_driver.refused; }

}  // namespace lumi
