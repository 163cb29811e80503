#pragma once

#include <numeric>
#include <vector>

#include "calib/capture/capture.h"

namespace lumi {

/// The indices of all views of a capture, for what takes a choice of them.
[[nodiscard]] inline std::vector<int> all_views(const Capture& capture) {
    std::vector<int> indices(capture.views.size());
    std::iota(indices.begin(), indices.end(), 0);
    return indices;
}

}  // namespace lumi
