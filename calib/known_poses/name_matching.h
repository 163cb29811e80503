#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace lumi {

/// For each name of `wanted` the index in `available` of what is meant by it.
///
/// Programs keep different parts of a name: the whole, the last folder, the file name, the stem
/// (which may hold a dot itself), or the last word where they cut lines at blanks. The part by
/// which most names match decides for all; a part that two names share matches nothing.
[[nodiscard]] std::vector<std::optional<std::size_t>> matched_names(
    const std::vector<std::string>& wanted, const std::vector<std::string>& available);

}  // namespace lumi
