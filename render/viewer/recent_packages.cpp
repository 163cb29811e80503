#include "render/viewer/recent_packages.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPackages = 10;
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 16;

fs::path folder_in(const char* variable) {
    const char* const value = std::getenv(variable);
    const fs::path folder = value == nullptr ? fs::path() : fs::path(value);
    // The specification: relative paths are to be ignored.
    return folder.is_absolute() ? folder : fs::path();
}

bool is_package(const fs::path& folder) {
    std::error_code ignored;
    return folder.is_absolute() && fs::exists(folder / kManifestName, ignored);
}

}  // namespace

fs::path recent_packages_file() {
    if (const fs::path state = folder_in("XDG_STATE_HOME"); !state.empty())
        return state / "lumi" / "recent";
    if (const fs::path home = folder_in("HOME"); !home.empty())
        return home / ".local" / "state" / "lumi" / "recent";
    return {};
}

std::vector<fs::path> read_recent_packages(const fs::path& file) {
    std::vector<fs::path> packages;
    std::string text;
    try {
        text = read_whole_text(file, kMaxFileBytes);
    } catch (const Error&) {
        return packages;  // A list that is not there, or no list, must not keep a window shut.
    }
    std::istringstream lines(text);
    for (std::string line; packages.size() < kMostPackages && std::getline(lines, line);)
        if (is_package(line)) packages.emplace_back(line);
    return packages;
}

void remember_package(const fs::path& package, const fs::path& file) {
    std::error_code failed;
    const fs::path place = fs::canonical(package, failed);
    // A line holds one path.
    if (failed || place.string().find('\n') != std::string::npos) return;
    std::vector<fs::path> packages = read_recent_packages(file);
    std::erase(packages, place);
    packages.insert(packages.begin(), place);
    packages.resize(std::min(packages.size(), kMostPackages));
    std::string text;
    for (const fs::path& known : packages) text += known.string() + "\n";
    write_whole_text(file, text);
}

}  // namespace lumi
