#include "calib/boards/picture_faults.h"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace lumi {
namespace {

/// Grey levels below which `share` of the values lie.
int quantile(const std::array<std::size_t, 256>& histogram, double share) {
    std::size_t total = 0;
    for (const std::size_t count : histogram) total += count;
    std::size_t below = 0;
    for (std::size_t value = 0; value < histogram.size(); ++value) {
        below += histogram[value];
        if (static_cast<double>(below) >= share * static_cast<double>(total)) {
            return static_cast<int>(value);
        }
    }
    return 255;
}

}  // namespace

std::string picture_fault(const GrayImage& picture) {
    std::array<std::size_t, 256> values{};
    std::array<std::size_t, 256> steps{};
    for (int y = 0; y < picture.height(); ++y) {
        const std::uint8_t* const row = picture.row(y);
        for (int x = 0; x < picture.width(); ++x) {
            ++values[row[x]];
            if (x > 0) ++steps[static_cast<std::size_t>(std::abs(row[x] - row[x - 1]))];
        }
    }
    constexpr int kDark = 50;
    constexpr int kWhite = 250;
    constexpr int kSoftStep = 12;
    if (quantile(values, 0.99) < kDark) return "the photograph is too dark";
    if (quantile(values, 0.6) >= kWhite) return "most of the photograph is overexposed";
    if (quantile(steps, 0.999) < kSoftStep) {
        return "the photograph is blurred, or has no contrast";
    }
    return {};
}

}  // namespace lumi
