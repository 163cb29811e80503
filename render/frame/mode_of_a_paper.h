#pragma once

#include "render/frame/frame.h"

namespace lumi {

/// Whether the mode draws what a paper says and no more: it heeds neither fade_beyond_capture nor
/// guess_surroundings.
[[nodiscard]] inline bool is_of_a_paper(RenderMode mode) {
    return mode == RenderMode::kPaper2001 || mode == RenderMode::kHeigl;
}

}  // namespace lumi
