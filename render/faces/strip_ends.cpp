#include "render/faces/strip_ends.h"

#include <algorithm>
#include <cmath>

#include "render/lumigraph/drawing_choices.h"

namespace lumi {

std::vector<int> strip_ends(const std::vector<double>& shares, int width_px) {
    const int blocks = (width_px + kDepthBlockSide_px - 1) / kDepthBlockSide_px;
    std::vector<int> ends;
    double sum = 0;
    for (const double share : shares) {
        sum += share;
        const auto end = static_cast<int>(std::lround(sum * blocks));
        ends.push_back(std::min(kDepthBlockSide_px * end, width_px));
    }
    ends.back() = width_px;
    return ends;
}

}  // namespace lumi
