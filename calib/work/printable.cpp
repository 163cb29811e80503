#include "calib/work/printable.h"

#include <cstddef>
#include <cstdint>

namespace lumi {
namespace {

std::uint8_t byte_at(std::string_view text, std::size_t index) {
    return static_cast<std::uint8_t>(text[index]);
}

/// Length of the UTF-8 character that begins at `index`; 0 when none does. Overlong forms and
/// surrogates are refused by the lead byte and the smallest second byte (Unicode 15, table 3-7).
std::size_t character_length(std::string_view text, std::size_t index) {
    const std::uint8_t lead = byte_at(text, index);
    if (lead < 0x80) return 1;
    const std::size_t length = lead >= 0xc2 && lead <= 0xdf   ? 2
                               : lead >= 0xe0 && lead <= 0xef ? 3
                               : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                              : 0;
    if (length == 0 || index + length > text.size()) return 0;
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte_at(text, index + i) & 0xc0) != 0x80) return 0;
    }
    const std::uint8_t second = byte_at(text, index + 1);
    const bool legal = (lead != 0xe0 || second >= 0xa0) && (lead != 0xed || second <= 0x9f) &&
                       (lead != 0xf0 || second >= 0x90) && (lead != 0xf4 || second <= 0x8f);
    return legal ? length : 0;
}

bool is_control(std::string_view character) {
    const std::uint8_t lead = byte_at(character, 0);
    if (character.size() == 1) return lead < 0x20 || lead == 0x7f;
    return character.size() == 2 && lead == 0xc2 && byte_at(character, 1) < 0xa0;
}

}  // namespace

bool is_utf8(std::string_view text) {
    std::size_t index = 0;
    while (index < text.size()) {
        const std::size_t length = character_length(text, index);
        if (length == 0) return false;
        index += length;
    }
    return true;
}

std::string printable(std::string_view text) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string result;
    for (std::size_t index = 0; index < text.size();) {
        const std::size_t length = character_length(text, index);
        const std::string_view character = text.substr(index, length == 0 ? 1 : length);
        if (length > 0 && !is_control(character)) {
            result += character;
        } else {
            for (const char c : character) {
                const auto byte = static_cast<std::uint8_t>(c);
                result += "\\x";
                result += kDigits[byte >> 4];
                result += kDigits[byte & 15];
            }
        }
        index += character.size();
    }
    return result;
}

}  // namespace lumi
