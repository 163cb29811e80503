#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace lumi {

/// What the panel tells of the last frame.
struct FrameStatistics {
    double frame_ms = 0.0;
    int width_px = 0;
    int height_px = 0;
    std::size_t triangles = 0;
    std::vector<float> recent_frames_ms;  ///< The oldest first.
    std::string gl_description;
    std::string message;      ///< The last thing that happened, or failed; see `tell`.
    bool has_failed = false;  ///< That is what the message tells.
    int messages = 0;         ///< How many there were.
    std::string recording;    ///< Of a path, while it is recorded.

    void tell(const std::string& what) {
        message = what;
        has_failed = false;
        ++messages;
    }
    void tell_failure(const std::string& what) {
        tell(what);
        has_failed = true;
    }
};

}  // namespace lumi
