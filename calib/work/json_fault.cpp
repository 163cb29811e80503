#include "calib/work/json_fault.h"

#include <cstdio>

namespace lumi {

std::string json_fault(const std::string& where, const std::exception& fault) {
    // "[json.exception.parse_error.101] parse error at line 3, column 7: syntax error while parsing
    // value - unexpected '}'; expected ..."
    std::string text = fault.what();
    if (text.starts_with('[')) text.erase(0, text.find("] ") + 2);
    std::size_t line = 0;
    std::size_t column = 0;
    if (std::sscanf(text.c_str(), "parse error at line %zu, column %zu", &line, &column) == 2)
        return where + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " +
               text.substr(text.find(" - ") + 3);
    if (text.starts_with("cannot use"))
        return where + ": expected another type of value than " + text.substr(text.rfind(' ') + 1);
    return where + ": " + (text.starts_with("type must be") ? "a value's " : "") + text;
}

}  // namespace lumi
