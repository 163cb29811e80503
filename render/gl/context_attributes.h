#pragma once

#include <epoxy/egl.h>

#include <array>

namespace lumi {

/// What eglCreateContext is asked for: OpenGL ES 3.0 or OpenGL 3.3 core.
inline std::array<EGLint, 7> context_attributes(bool is_es) {
    if (is_es) return {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE, 0, 0};
    return {EGL_CONTEXT_MAJOR_VERSION,
            3,
            EGL_CONTEXT_MINOR_VERSION,
            3,
            EGL_CONTEXT_OPENGL_PROFILE_MASK,
            EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
            EGL_NONE};
}

}  // namespace lumi
