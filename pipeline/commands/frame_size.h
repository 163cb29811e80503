#pragma once

#include <string>

namespace lumi {

struct FrameSize {
    int width_px = 0;
    int height_px = 0;
};

/// What --size says, such as "1280x720". Throws Error (E-RENDER-SIZE).
[[nodiscard]] FrameSize frame_size_from(const std::string& text);

}  // namespace lumi
