#pragma once

#include <string>

namespace lumi {

/// Which OpenGL a context is asked for.
enum class GlApi {
    kAny,   ///< OpenGL 3.3 core, or else OpenGL ES 3.0.
    kCore,  ///< OpenGL 3.3 core.
    kEs,    ///< OpenGL ES 3.0.
};

/// An OpenGL context without a window or a surface: EGL on a graphics card, on Mesa's surfaceless
/// platform, on a software device, or on the default display, whichever answers first. With
/// LIBGL_ALWAYS_SOFTWARE=1 in the environment graphics cards of all makers are passed over.
class HeadlessContext {
 public:
    /// Makes the context and makes it current. Throws Error (E-GL-CONTEXT) that lists what was
    /// tried and how each attempt ended.
    explicit HeadlessContext(GlApi api = GlApi::kAny);
    ~HeadlessContext();
    HeadlessContext(HeadlessContext&& other) noexcept;
    HeadlessContext& operator=(HeadlessContext&& other) noexcept;

    /// Makes this the calling thread's context. Throws Error (E-GL-CONTEXT).
    void make_current() const;
    /// The same; false where EGL does not.
    [[nodiscard]] bool try_make_current() const noexcept;

 private:
    /// Makes it current. What speaks against using it; nothing where it serves.
    [[nodiscard]] std::string refusal() const;
    void destroy();

    void* display_ = nullptr;  ///< EGLDisplay
    void* context_ = nullptr;  ///< EGLContext
};

}  // namespace lumi
