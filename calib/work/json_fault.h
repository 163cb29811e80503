#pragma once

#include <exception>
#include <string>

namespace lumi {

/// What is wrong with JSON in `where` (a file), in words, of an exception of the JSON library: with
/// line and column where the text is no JSON ("a.json:3:7: unexpected '}'; expected ..."), else
/// what a value lacks or should be.
[[nodiscard]] std::string json_fault(const std::string& where, const std::exception& fault);

}  // namespace lumi
