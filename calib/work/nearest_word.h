#pragma once

#include <optional>
#include <set>
#include <string>

namespace lumi {

/// The one of `known` that was probably meant by a misspelt word: the nearest by the edits between
/// them (Levenshtein, Binary codes capable of correcting deletions, insertions and reversals,
/// 1966); empty where even that differs in more than every other letter.
[[nodiscard]] std::optional<std::string> nearest_word(const std::string& word,
                                                      const std::set<std::string>& known);

}  // namespace lumi
