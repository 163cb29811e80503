#include "pipeline/text/hyphenated.h"

namespace lumi {
namespace {

bool is_of_a_word(char character) {
    return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') ||
           (character >= '0' && character <= '9') || character == '.';
}

}  // namespace

std::string hyphenated(const std::string& text) {
    std::string words;
    bool is_between = false;
    for (const char character : text) {
        if (!is_of_a_word(character)) {
            is_between = !words.empty();
            continue;
        }
        if (is_between) words += '-';
        is_between = false;
        words += character;
    }
    return words;
}

}  // namespace lumi
