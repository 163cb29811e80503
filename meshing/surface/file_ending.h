#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace lumi {

/// The extension of a file's name in lower case: ".PLY", ".Ply" and ".ply" are one.
[[nodiscard]] inline std::string lower_case_ending(const std::filesystem::path& path) {
    std::string ending = path.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

}  // namespace lumi
