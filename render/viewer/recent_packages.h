#pragma once

#include <filesystem>
#include <vector>

namespace lumi {

/// Where the list of packages that were opened is kept: `lumi/recent` in $XDG_STATE_HOME or
/// ~/.local/state (XDG Base Directory Specification 0.8). Empty where there is neither.
[[nodiscard]] std::filesystem::path recent_packages_file();

/// The packages of a list, the last opened first: one absolute path a line, at most ten. Those that
/// are gone and lines that are no path are left out; without a file there are none.
[[nodiscard]] std::vector<std::filesystem::path> read_recent_packages(
    const std::filesystem::path& file);

/// Puts a package at the head of the list. Throws Error (E-FILE-WRITE).
void remember_package(const std::filesystem::path& package, const std::filesystem::path& file);

}  // namespace lumi
