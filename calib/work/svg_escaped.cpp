#include "calib/work/svg_escaped.h"

namespace lumi {

std::string svg_escaped(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '&') {
            escaped += "&amp;";
        } else if (c == '<') {
            escaped += "&lt;";
        } else if (c == '>') {
            escaped += "&gt;";
        } else if (static_cast<unsigned char>(c) >= ' ') {
            escaped += c;
        }
    }
    return escaped;
}

}  // namespace lumi
