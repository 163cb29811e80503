#include "tests/house/type_names.h"

#include <fstream>
#include <map>
#include <regex>

#include "tests/house/room_sources.h"

namespace lumi {

namespace fs = std::filesystem;

std::vector<std::string> type_names_taken_twice(const fs::path& repository) {
    // Namespaces are not indented, members are.
    static const std::regex kDefinition(R"(^(?:struct|class|enum class) (\w+)[^;]*\{.*)");
    std::map<std::string, std::string> header_of_name;
    std::vector<std::string> taken_twice;
    for (const fs::path& path : room_sources(repository)) {
        if (path.extension() != ".h") continue;
        const std::string header = fs::relative(path, repository).generic_string();
        std::ifstream stream(path);
        std::string text;
        for (int line = 1; std::getline(stream, text); ++line) {
            std::smatch match;
            if (!std::regex_match(text, match, kDefinition)) continue;
            const auto [first, is_new] = header_of_name.emplace(match[1], header);
            if (is_new || first->second == header) continue;
            taken_twice.push_back(header + ":" + std::to_string(line) + ": " + first->first +
                                  " is in " + first->second + ", too");
        }
    }
    return taken_twice;
}

}  // namespace lumi
