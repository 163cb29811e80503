#include "tests/house/test_places.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "tests/house/room_sources.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kSuffix = "_test.cpp";

/// The folders, from the repository on, in which something of a name lies.
std::map<std::string, std::set<fs::path>> folders_of_names(const fs::path& repository) {
    std::map<std::string, std::set<fs::path>> folders;
    for (const fs::path& path : room_sources(repository))
        folders[path.stem().string()].insert(fs::relative(path, repository).parent_path());
    return folders;
}

std::vector<fs::path> test_sources(const fs::path& repository) {
    std::vector<fs::path> tests;
    for (const auto& entry : fs::recursive_directory_iterator(repository / "tests"))
        if (entry.path().filename().string().ends_with(kSuffix)) tests.push_back(entry.path());
    std::sort(tests.begin(), tests.end());
    return tests;
}

}  // namespace

std::vector<std::string> misplaced_tests(const fs::path& repository) {
    const std::map<std::string, std::set<fs::path>> folders = folders_of_names(repository);
    std::vector<std::string> misplaced;
    for (const fs::path& path : test_sources(repository)) {
        std::string name = path.filename().string();
        name.resize(name.size() - kSuffix.size());
        const auto named = folders.find(name);
        if (named == folders.end()) continue;
        const fs::path file = fs::relative(path, repository);
        const fs::path room_folder = fs::relative(file.parent_path(), "tests");
        if (named->second.contains(room_folder)) continue;
        misplaced.push_back(file.generic_string() + ": belongs to " +
                            (fs::path("tests") / *named->second.begin()).generic_string());
    }
    return misplaced;
}

}  // namespace lumi
