#include "render/faces/strip_ends.h"

#include <cmath>

namespace lumi {

std::vector<int> strip_ends(const std::vector<double>& shares, int width_px) {
    std::vector<int> ends;
    double sum = 0;
    for (const double share : shares) {
        sum += share;
        ends.push_back(static_cast<int>(std::lround(sum * width_px)));
    }
    ends.back() = width_px;
    return ends;
}

}  // namespace lumi
