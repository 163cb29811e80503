#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace lumi {

/// Counts the texture lookups of fragment shaders. While one lives, programs that are made in its
/// thread count each lookup that a fragment makes, also where depth test or blending reject what
/// comes of it; they draw what they would draw otherwise, more slowly. A context must be current.
/// One at a time.
class LookupMeter {
 public:
    LookupMeter();
    ~LookupMeter();
    LookupMeter(const LookupMeter&) = delete;
    LookupMeter& operator=(const LookupMeter&) = delete;

    /// Lookups that `draw` makes in programs that were made since the meter. Nothing where the
    /// context cannot count (before OpenGL 4.2, OpenGL ES).
    [[nodiscard]] std::optional<std::uint64_t> lookups(const std::function<void()>& draw) const;
};

/// What the text of a fragment shader begins with, after its version, so that its lookups are
/// counted; nothing while no meter lives.
[[nodiscard]] std::string lookup_counting_source();

}  // namespace lumi
