#pragma once

#include <concepts>
#include <string>

namespace lumi {

/// A count and what it counts, in words: "1 view", "3 views". `one` is a word whose plural ends in
/// s.
template <std::integral Count>
[[nodiscard]] std::string counted(Count count, const std::string& one) {
    return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

}  // namespace lumi
