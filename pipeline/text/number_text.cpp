#include "pipeline/text/number_text.h"

#include <array>
#include <charconv>

namespace lumi {

std::string number_text(double value, int decimals) {
    std::array<char, 400> text{};  // The largest double has 309 digits before its point.
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value,
                                      std::chars_format::fixed, decimals);
    return {text.data(), result.ptr};
}

std::string shortest_number_text(double value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

}  // namespace lumi
