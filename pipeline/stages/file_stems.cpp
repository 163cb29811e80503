#include "pipeline/stages/file_stems.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace lumi {
namespace {

bool is_portable(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '.';
}

std::string portable_stem(const std::string& name) {
    const std::size_t dot = name.rfind('.');
    const std::size_t slash = name.rfind('/');
    const bool has_ending =
        dot != std::string::npos && dot > 0 && (slash == std::string::npos || dot > slash + 1);
    std::string stem = has_ending ? name.substr(0, dot) : name;
    for (char& c : stem) {
        if (!is_portable(c)) c = '_';
    }
    if (stem.front() == '.') stem.front() = '_';
    constexpr std::size_t kMostLetters = 200;  // File systems take 255, endings included.
    if (stem.size() > kMostLetters) stem.resize(kMostLetters);
    return stem;
}

}  // namespace

std::vector<std::string> file_stems_of_views(const std::vector<std::string>& names) {
    std::set<std::string> taken;
    std::vector<std::string> stems;
    for (const std::string& name : names) {
        const std::string stem = portable_stem(name);
        std::string unique = stem;
        for (int number = 2; !taken.insert(unique).second; ++number) {
            unique = stem + '-' + std::to_string(number);
        }
        stems.push_back(unique);
    }
    return stems;
}

std::vector<std::string> file_stems_without_dots(std::vector<std::string> names) {
    for (std::string& name : names) {
        const std::size_t ending = std::min(name.rfind('.'), name.size());
        std::replace(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(ending), '.', '_');
    }
    return file_stems_of_views(names);
}

}  // namespace lumi
