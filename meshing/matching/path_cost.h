#pragma once

#include <cstdint>

namespace lumi {

/// Path costs of one pixel are kept with one guard before and one after them, both kUnreachable.
/// All sums stay below it: kMaxMatchingCost + P1 + P2 < kUnreachable, kUnreachable + P1 <= 255.
constexpr std::uint8_t kUnreachable = 220;

/// A path on its way into a pixel.
struct IncomingPath {
    /// Path costs of the pixel it comes from, aligned to the planes of this one, and of this one;
    /// both point past their guard.
    const std::uint8_t* previous = nullptr;
    std::uint8_t* current = nullptr;
    std::uint8_t previous_min = 0;
    std::uint8_t p2 = 0;
};

constexpr int kPathsAtOnce = 4;

/// One step along four paths that meet in a pixel (Hirschmueller 2008, eq. 13), for each of them
///   current[k] = cost[k] + min(previous[k], previous[k-1] + p1, previous[k+1] + p1,
///                              previous_min + p2) - previous_min
/// for `count` planes, a multiple of 8, and its least current cost in `minima`. The sum over the
/// paths is written to `sum`, or added where `adds`.
void advance_paths(const std::uint8_t* cost, const IncomingPath paths[kPathsAtOnce],
                   std::uint8_t p1, int count, bool adds, std::uint16_t* sum,
                   std::uint8_t minima[kPathsAtOnce]);

}  // namespace lumi
