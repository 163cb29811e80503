#include "render/depth_mesh/halved_depth.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace lumi {
namespace {

/// Up to four inverse depths.
struct Samples {
    std::array<float, 4> inverse_depths{};
    std::size_t count = 0;

    void add(float inverse_depth) { inverse_depths[count++] = inverse_depth; }
    /// Insertion keeps them in order.
    void sort() {
        for (std::size_t i = 1; i < count; ++i)
            for (std::size_t k = i; k > 0 && inverse_depths[k] < inverse_depths[k - 1]; --k)
                std::swap(inverse_depths[k], inverse_depths[k - 1]);
    }
};

/// The mean of the most numerous surface; `samples` are sorted.
float mean_of_surface(const Samples& samples, double max_gap) {
    const std::array<float, 4>& q = samples.inverse_depths;
    std::size_t begin = 0;
    std::size_t end = samples.count;
    float widest = 0;
    std::size_t behind = 0;  // As many lie behind the widest gap.
    for (std::size_t i = 1; i < samples.count; ++i) {
        if (q[i] - q[i - 1] <= widest) continue;
        widest = q[i] - q[i - 1];
        behind = i;
    }
    if (static_cast<double>(widest) > max_gap) (2 * behind > samples.count ? end : begin) = behind;
    float sum = 0;
    for (std::size_t i = begin; i < end; ++i) sum += q[i];
    return sum / static_cast<float>(end - begin);
}

/// The first (0) or second (1) of two samples in a row of `count` that one of half as many stands
/// for; both maps cover the same field of view, also when the count is odd.
int source_of(int half_index, int which, int count) {
    return (4 * half_index + 1 + 2 * which) * count / (4 * ((count + 1) / 2));
}

}  // namespace

DepthMap halved(const DepthMap& depth, double max_gap) {
    const int columns = depth.inverse_depth.width();
    const int rows = depth.inverse_depth.height();
    DepthMap half{FloatImage((columns + 1) / 2, (rows + 1) / 2),
                  GrayImage((columns + 1) / 2, (rows + 1) / 2)};
    for (int y = 0; y < half.inverse_depth.height(); ++y) {
        for (int x = 0; x < half.inverse_depth.width(); ++x) {
            Samples seen;
            Samples filled;
            std::uint8_t confidence = 0;
            for (int i = 0; i < 4; ++i) {
                const int column = source_of(x, i % 2, columns);
                const int row = source_of(y, i / 2, rows);
                const bool is_seen = depth.confidence(column, row) > 0;
                (is_seen ? seen : filled).add(depth.inverse_depth(column, row));
                confidence = std::max(confidence, depth.confidence(column, row));
            }
            Samples& counting = seen.count >= 2 ? seen : filled;
            counting.sort();
            half.inverse_depth(x, y) = mean_of_surface(counting, max_gap);
            half.confidence(x, y) = seen.count >= 2 ? confidence : std::uint8_t{0};
        }
    }
    return half;
}

}  // namespace lumi
