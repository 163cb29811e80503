#include "pipeline/chart/label_choice.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace lumi {
namespace {

/// Shares of the picture, for the plots' small print.
constexpr double kHeight = 0.06;
constexpr double kWidthOfLetter = 0.015;

bool cover_each_other(const PlacedLabel& a, const PlacedLabel& b) {
    if (std::abs(a.y - b.y) >= kHeight) return false;
    const PlacedLabel& left = a.x < b.x ? a : b;
    const PlacedLabel& right = a.x < b.x ? b : a;
    return left.x + kWidthOfLetter * static_cast<double>(left.text.size()) > right.x;
}

}  // namespace

std::vector<bool> readable_labels(const std::vector<PlacedLabel>& labels) {
    std::vector<std::size_t> order(labels.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return labels[a].y < labels[b].y; });
    std::vector<bool> is_readable(labels.size(), false);
    for (const std::size_t index : order) {
        is_readable[index] = true;
        for (std::size_t other = 0; other < labels.size(); ++other) {
            if (other != index && is_readable[other] &&
                cover_each_other(labels[index], labels[other])) {
                is_readable[index] = false;
                break;
            }
        }
    }
    return is_readable;
}

}  // namespace lumi
