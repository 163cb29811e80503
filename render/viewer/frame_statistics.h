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
    std::string message;    ///< The last thing that happened, or failed.
    std::string recording;  ///< Of a path, while it is recorded.
};

}  // namespace lumi
