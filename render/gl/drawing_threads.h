#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace lumi {

/// The calling thread and others beside it, each with an OpenGL context of its own. They share
/// textures, buffers and programs, but neither framebuffers nor vertex arrays; and a program in use
/// by several has one set of uniforms.
///
/// Where OpenGL works on the CPU, the thread that hands it triangles transforms and sorts them by
/// itself, and only pixels are filled on all cores. Several threads share that work. Where it works
/// on a GPU, there is the calling thread alone.
class DrawingThreads {
 public:
    /// At most so many, the caller among them, beside the context that is current; fewer where
    /// there are fewer cores, or where EGL gives no further context that shares with this one.
    explicit DrawingThreads(int most);
    ~DrawingThreads();
    DrawingThreads(const DrawingThreads&) = delete;
    DrawingThreads& operator=(const DrawingThreads&) = delete;

    /// The caller's thread counts.
    [[nodiscard]] std::size_t size() const { return 1 + others_.size(); }
    /// Calls task(0) in the calling thread and task(1) ... task(size() - 1) in the others, all at
    /// once. Each finds what the caller has drawn before; when this returns, the caller finds what
    /// all of them have drawn. What several of them draw into one texture comes in any order.
    /// Throws what a task has thrown, after all have ended.
    void run(const std::function<void(std::size_t thread)>& task);

 private:
    class Other;
    std::vector<std::unique_ptr<Other>> others_;
};

}  // namespace lumi
