#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace lumi {

/// What the names of files and folders begin with that are to become `target` when they are whole:
/// hidden, and unlike any name that somebody gives to a copy.
[[nodiscard]] std::string unfinished_prefix(const std::filesystem::path& target);

/// Lets `make`, a call of the system that returns less than 0 and sets errno where it fails, make
/// something beside `target` whose name nobody else has; its path. Throws Error (E-FILE-WRITE).
std::filesystem::path make_unfinished_sibling(const std::filesystem::path& target,
                                              const std::function<int(const char* path)>& make);

}  // namespace lumi
