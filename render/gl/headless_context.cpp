#include "render/gl/headless_context.h"

#include <epoxy/egl.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <utility>
#include <vector>

#include "calib/work/error.h"
#include "render/gl/capabilities.h"

namespace lumi {

namespace {

struct Platform {
    const char* name;
    EGLDisplay display;
};

std::string egl_error_text() {
    constexpr std::array<std::pair<EGLint, const char*>, 6> kNames{
        {{EGL_NOT_INITIALIZED, "not initialised"},
         {EGL_BAD_ALLOC, "out of resources"},
         {EGL_BAD_MATCH, "version or profile not offered"},
         {EGL_BAD_CONFIG, "no such configuration"},
         {EGL_BAD_ATTRIBUTE, "attribute not known"},
         {EGL_BAD_DISPLAY, "no such display"}}};
    const EGLint error = eglGetError();
    for (const auto& [value, name] : kNames)
        if (value == error) return name;
    return "EGL error " + std::to_string(error);
}

/// The way in which Mesa is asked for its software renderer; other drivers do not know it.
bool is_software_wanted() {
    const char* value = std::getenv("LIBGL_ALWAYS_SOFTWARE");
    if (value == nullptr) return false;
    constexpr std::array<std::string_view, 8> kNo{"", "0", "n", "no", "f", "F", "false", "FALSE"};
    return std::find(kNo.begin(), kNo.end(), value) == kNo.end();
}

/// What tells nothing of itself is none.
bool is_graphics_card(EGLDeviceEXT device) {
    const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
    return extensions != nullptr &&
           std::string_view(extensions).find("EGL_MESA_device_software") == std::string_view::npos;
}

std::vector<EGLDeviceEXT> devices() {
    const auto has = [](const char* name) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, name); };
    // Older drivers name alone what was split into the other two.
    const bool has_base = has("EGL_EXT_device_base") ||
                          (has("EGL_EXT_device_enumeration") && has("EGL_EXT_device_query"));
    if (!has_base || !has("EGL_EXT_platform_device")) return {};
    EGLint count = 0;
    if (eglQueryDevicesEXT(0, nullptr, &count) == EGL_FALSE || count < 1) return {};
    std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
    if (eglQueryDevicesEXT(count, found.data(), &count) == EGL_FALSE) return {};
    found.resize(static_cast<std::size_t>(count));
    return found;
}

EGLDisplay display_of(EGLDeviceEXT device) {
    return eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device, nullptr);
}

/// Graphics cards first: of an NVIDIA card Mesa's platform knows nothing.
std::vector<Platform> platforms() {
    const std::vector<EGLDeviceEXT> all = devices();
    std::vector<Platform> found;
    for (const EGLDeviceEXT device : all)
        if (is_graphics_card(device) && !is_software_wanted())
            found.push_back({"graphics card", display_of(device)});
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        found.push_back({"surfaceless", eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA,
                                                                 nullptr, nullptr)});
    for (const EGLDeviceEXT device : all)
        if (!is_graphics_card(device)) found.push_back({"software", display_of(device)});
    found.push_back({"default display", eglGetDisplay(EGL_DEFAULT_DISPLAY)});
    return found;
}

/// A context of exactly this API, or EGL_NO_CONTEXT with eglGetError() telling why.
EGLContext create_context(EGLDisplay display, GlApi api) {
    const bool is_es = api == GlApi::kEs;
    if (eglBindAPI(is_es ? EGL_OPENGL_ES_API : EGL_OPENGL_API) == EGL_FALSE) return EGL_NO_CONTEXT;
    const std::array<EGLint, 5> wanted{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                       is_es ? EGL_OPENGL_ES3_BIT : EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count < 1)
        return EGL_NO_CONTEXT;
    const std::array<EGLint, 7> core{EGL_CONTEXT_MAJOR_VERSION,
                                     3,
                                     EGL_CONTEXT_MINOR_VERSION,
                                     3,
                                     EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                     EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                     EGL_NONE};
    const std::array<EGLint, 5> es{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0,
                                   EGL_NONE};
    return eglCreateContext(display, config, EGL_NO_CONTEXT, is_es ? es.data() : core.data());
}

std::vector<GlApi> apis_to_try(GlApi api) {
    if (api == GlApi::kAny) return {GlApi::kCore, GlApi::kEs};
    return {api};
}

const char* name_of(GlApi api) { return api == GlApi::kEs ? "OpenGL ES 3.0" : "OpenGL 3.3 core"; }

Error no_context(const std::string& attempts) {
    return {ErrorKind::kResources, "E-GL-CONTEXT",
            "no OpenGL 3.3 core or OpenGL ES 3.0 context without a window; tried" + attempts,
            "install Mesa's software renderer (Debian: libegl-mesa0 libgl1-mesa-dri), or unset "
            "MESA_GL_VERSION_OVERRIDE and LIBGL_DRIVERS_PATH if they are set"};
}

}  // namespace

HeadlessContext::HeadlessContext(GlApi api) {
    std::string attempts;
    for (const Platform& platform : platforms()) {
        if (platform.display == EGL_NO_DISPLAY ||
            eglInitialize(platform.display, nullptr, nullptr) == EGL_FALSE) {
            attempts += std::string("; ") + platform.name + ": no display";
            continue;
        }
        for (const GlApi wanted : apis_to_try(api)) {
            const EGLContext context = create_context(platform.display, wanted);
            if (context == EGL_NO_CONTEXT) {
                attempts += std::string("; ") + platform.name + ", " + name_of(wanted) + ": " +
                            egl_error_text();
                continue;
            }
            display_ = platform.display;
            context_ = context;
            const std::string why_not = refusal();
            if (why_not.empty()) return;
            attempts += std::string("; ") + platform.name + ", " + name_of(wanted) + ": " + why_not;
            destroy();
        }
    }
    throw no_context(attempts);
}

std::string HeadlessContext::refusal() const {
    if (!try_make_current()) return "cannot be made current: " + egl_error_text();
    try {
        if (is_software_wanted() && !query_capabilities().works_on_cpu) return "a graphics card";
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

// The display is never terminated: EGL gives every caller the same one, so that ending it would
// pull it from under the other contexts of the process.
HeadlessContext::~HeadlessContext() { destroy(); }

void HeadlessContext::destroy() {
    if (context_ == nullptr) return;
    if (eglGetCurrentContext() == context_)
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    context_ = nullptr;
}

HeadlessContext::HeadlessContext(HeadlessContext&& other) noexcept
    : display_(other.display_), context_(std::exchange(other.context_, nullptr)) {}

HeadlessContext& HeadlessContext::operator=(HeadlessContext&& other) noexcept {
    std::swap(display_, other.display_);
    std::swap(context_, other.context_);
    return *this;
}

bool HeadlessContext::try_make_current() const noexcept {
    return eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_FALSE;
}

void HeadlessContext::make_current() const {
    if (!try_make_current()) throw no_context("; making the context current: " + egl_error_text());
}

}  // namespace lumi
