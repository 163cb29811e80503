#include "meshing/agreement/gap_closing.h"

#include <algorithm>
#include <array>

namespace lumi {
namespace {

/// How many of the 3 x 3 pixels around each are known; 0 along the border.
GrayImage known_around(const GrayImage& confidence) {
    const int width = confidence.width();
    GrayImage sums(width, confidence.height());
    std::vector<std::uint8_t> column_sums(static_cast<std::size_t>(width));
    for (int y = 1; y + 1 < confidence.height(); ++y) {
        const std::uint8_t* above = confidence.row(y - 1);
        const std::uint8_t* own = confidence.row(y);
        const std::uint8_t* below = confidence.row(y + 1);
        for (int x = 0; x < width; ++x) {
            column_sums[static_cast<std::size_t>(x)] =
                static_cast<std::uint8_t>((above[x] != 0) + (own[x] != 0) + (below[x] != 0));
        }
        std::uint8_t* out = sums.row(y);
        for (int x = 1; x + 1 < width; ++x) {
            const std::uint8_t* column = column_sums.data() + x;
            out[x] = static_cast<std::uint8_t>(column[-1] + column[0] + column[1]);
        }
    }
    return sums;
}

/// Median of what is known in the 3 x 3 pixels around (x, y).
float median_around(const DepthMap& map, int x, int y) {
    std::array<float, 9> hits;
    std::size_t count = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            if (map.confidence(x + dx, y + dy) == 0) continue;
            hits[count++] = map.inverse_depth(x + dx, y + dy);
        }
    }
    const auto middle = hits.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(hits.begin(), middle, hits.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
}

}  // namespace

DepthMap with_gaps_closed(const DepthMap& map) {
    constexpr std::uint8_t kMinHits = 4;
    const int width = map.confidence.width();
    const int height = map.confidence.height();
    const GrayImage hits = known_around(map.confidence);
    DepthMap result{FloatImage(width, height), GrayImage(width, height)};
    for (int y = 1; y + 1 < height; ++y) {
        for (int x = 1; x + 1 < width; ++x) {
            if (hits(x, y) < kMinHits) continue;
            result.inverse_depth(x, y) = median_around(map, x, y);
            result.confidence(x, y) = kKnown;
        }
    }
    return result;
}

}  // namespace lumi
