#include "render/gl/drawing_threads.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "calib/work/parallel_for.h"
#include "render/gl/capabilities.h"
#include "render/gl/context_attributes.h"

namespace lumi {
namespace {

EGLint attribute_of(EGLDisplay display, EGLContext context, EGLint attribute) {
    EGLint value = 0;
    eglQueryContext(display, context, attribute, &value);
    return value;
}

/// Whether several contexts in this process gain anything, and can be made current without a
/// surface.
bool has_use_for_others() {
    if (!query_capabilities().works_on_cpu || !epoxy_has_egl()) return false;
    return eglGetCurrentContext() != EGL_NO_CONTEXT &&
           epoxy_has_egl_extension(eglGetCurrentDisplay(), "EGL_KHR_surfaceless_context");
}

/// One of the API of the current context; EGL_NO_CONTEXT where there is none to be had.
EGLContext context_sharing_with_current() {
    const EGLDisplay display = eglGetCurrentDisplay();
    const EGLContext current = eglGetCurrentContext();
    const std::array<EGLint, 3> same_config{
        EGL_CONFIG_ID, attribute_of(display, current, EGL_CONFIG_ID), EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (eglChooseConfig(display, same_config.data(), &config, 1, &count) == EGL_FALSE || count < 1)
        return EGL_NO_CONTEXT;
    const EGLint api = attribute_of(display, current, EGL_CONTEXT_CLIENT_TYPE);
    if (eglBindAPI(static_cast<EGLenum>(api)) == EGL_FALSE) return EGL_NO_CONTEXT;
    return eglCreateContext(display, config, current,
                            context_attributes(api == EGL_OPENGL_ES_API).data());
}

}  // namespace

/// A thread that waits for tasks, with its context.
class DrawingThreads::Other {
 public:
    Other(EGLDisplay display, EGLContext context)
        : display_(display), context_(context), thread_([this] { work(); }) {}

    ~Other() {
        {
            const std::scoped_lock lock(mutex_);
            is_ending_ = true;
        }
        changed_.notify_all();
        thread_.join();
        eglDestroyContext(display_, context_);
    }
    Other(const Other&) = delete;
    Other& operator=(const Other&) = delete;

    /// Waits until the thread has tried to make its context current.
    [[nodiscard]] bool is_current() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return is_current_.has_value(); });
        return *is_current_;
    }

    /// The task before must have been waited for.
    void start(std::function<void()> task) {
        {
            const std::scoped_lock lock(mutex_);
            task_ = std::move(task);
        }
        changed_.notify_all();
    }

    /// Until the task has ended, and for the calling thread's context until its drawing is there.
    /// What the task has thrown, if anything.
    [[nodiscard]] std::exception_ptr wait() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [&] { return !task_; });
        if (drawn_ != nullptr) {
            glWaitSync(drawn_, 0, GL_TIMEOUT_IGNORED);
            glDeleteSync(std::exchange(drawn_, nullptr));
        }
        return std::exchange(failure_, nullptr);
    }

 private:
    void work() {
        std::unique_lock lock(mutex_);
        is_current_ =
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
        changed_.notify_all();
        while (true) {
            changed_.wait(lock, [&] { return task_ || is_ending_; });
            if (!task_) break;
            try {
                task_();
                drawn_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
                glFlush();
            } catch (...) {
                failure_ = std::current_exception();
            }
            task_ = nullptr;
            changed_.notify_all();
        }
        eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        eglReleaseThread();
    }

    EGLDisplay display_;
    EGLContext context_;
    std::mutex mutex_;  ///< Held by the thread while it works on a task.
    std::condition_variable changed_;
    std::optional<bool> is_current_;
    std::function<void()> task_;
    bool is_ending_ = false;
    GLsync drawn_ = nullptr;
    std::exception_ptr failure_;
    std::thread thread_;
};

DrawingThreads::DrawingThreads(int most) {
    const auto wanted = static_cast<std::size_t>(std::min(most, resolve_threads(0)));
    if (wanted < 2 || !has_use_for_others()) return;
    while (size() < wanted) {
        const EGLContext context = context_sharing_with_current();
        if (context == EGL_NO_CONTEXT) return;
        auto other = std::make_unique<Other>(eglGetCurrentDisplay(), context);
        if (!other->is_current()) return;
        others_.push_back(std::move(other));
    }
}

DrawingThreads::~DrawingThreads() = default;

void DrawingThreads::run(const std::function<void(std::size_t thread)>& task) {
    if (!others_.empty()) glFlush();
    for (std::size_t i = 0; i < others_.size(); ++i) others_[i]->start([&task, i] { task(i + 1); });
    std::exception_ptr failure;
    try {
        task(0);
    } catch (...) {
        failure = std::current_exception();
    }
    for (const std::unique_ptr<Other>& other : others_) {
        const std::exception_ptr others_failure = other->wait();
        if (!failure) failure = others_failure;
    }
    if (failure) std::rethrow_exception(failure);
}

}  // namespace lumi
