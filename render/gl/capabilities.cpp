#include "render/gl/capabilities.h"

#include <epoxy/gl.h>

#include "calib/work/error.h"

namespace lumi {

namespace {

std::string text(GLenum name) {
    const GLubyte* value = glGetString(name);
    if (value == nullptr) return "unknown";
    return {reinterpret_cast<const char*>(value)};
}

int integer(GLenum name) {
    GLint value = 0;
    glGetIntegerv(name, &value);
    return value;
}

}  // namespace

Capabilities query_capabilities() {
    Capabilities found;
    found.is_es = !epoxy_is_desktop_gl();
    found.version = epoxy_gl_version();
    const std::string renderer = text(GL_RENDERER);
    found.works_on_cpu = renderer.find("llvmpipe") != std::string::npos ||
                         renderer.find("softpipe") != std::string::npos;
    found.description = renderer + ", " + text(GL_VERSION);
    if (found.version < (found.is_es ? 30 : 33))
        throw Error(ErrorKind::kResources, "E-GL-CONTEXT",
                    "expected OpenGL 3.3 or OpenGL ES 3.0, found " + found.description,
                    "update the graphics driver, or use Mesa's software renderer "
                    "(LIBGL_ALWAYS_SOFTWARE=1)");
    found.max_texture_size_px = integer(GL_MAX_TEXTURE_SIZE);
    found.max_renderbuffer_size_px = integer(GL_MAX_RENDERBUFFER_SIZE);
    found.max_array_layers = integer(GL_MAX_ARRAY_TEXTURE_LAYERS);
    return found;
}

}  // namespace lumi
