#include "tests/house/room_sources.h"

#include <algorithm>

namespace lumi {
namespace {

namespace fs = std::filesystem;

bool is_source(const fs::path& path) {
    const fs::path extension = path.extension();
    return extension == ".h" || extension == ".cpp" || extension == ".inc" || extension == ".in";
}

}  // namespace

std::vector<fs::path> room_sources(const fs::path& repository) {
    std::vector<fs::path> files;
    for (const std::string_view room : kRooms) {
        if (!fs::exists(repository / room)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(repository / room)) {
            if (entry.is_regular_file() && is_source(entry.path())) files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace lumi
