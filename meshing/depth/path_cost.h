#pragma once

#include <cstdint>

namespace lumi {

/// Path costs of one pixel are kept with one guard before and one after them, both kUnreachable.
/// All sums stay below it: kMaxMatchingCost + P1 + P2 < kUnreachable, kUnreachable + P1 <= 255.
constexpr std::uint8_t kUnreachable = 220;

/// One step along a path (Hirschmueller 2008, eq. 13):
///   current[k] = cost[k] + min(previous[k], previous[k-1] + p1, previous[k+1] + p1,
///                              previous_min + p2) - previous_min
/// for `count` planes, a multiple of 8. Adds `current` to `sum` and returns its minimum. `previous`
/// is aligned to the planes of `current`; both point past their guard.
std::uint8_t advance_path(const std::uint8_t* cost, const std::uint8_t* previous,
                          std::uint8_t previous_min, std::uint8_t p1, std::uint8_t p2, int count,
                          std::uint8_t* current, std::uint16_t* sum);

}  // namespace lumi
