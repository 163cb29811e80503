#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>

namespace lumi {

/// How many fragments `draw` puts into framebuffers, over all its passes; those that a depth test
/// or the shader rejects are not counted. Nothing where the context cannot tell (OpenGL ES).
[[nodiscard]] std::optional<std::uint64_t> fragment_count(const std::function<void()>& draw);

/// How many bytes of vertices, indices and texels `draw` hands to OpenGL.
[[nodiscard]] std::uint64_t uploaded_bytes(const std::function<void()>& draw);
/// Adds to what uploaded_bytes counts: called by whoever hands bytes to OpenGL, in the thread that
/// draws.
void count_uploaded(std::size_t bytes);

/// Time by a graphics card's own clock from the first command of `draw` to the end of its last, in
/// milliseconds; what it waits for the CPU in between counts. Nothing where there is no card, as
/// Mesa's software renderers work on the CPU, or where the context cannot tell (OpenGL ES).
[[nodiscard]] std::optional<double> device_time_ms(const std::function<void()>& draw);

}  // namespace lumi
