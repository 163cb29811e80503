#include "calib/known_poses/name_matching.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>

namespace lumi {
namespace {

namespace fs = std::filesystem;
using NamePart = std::string (*)(const std::string&);
using Matches = std::vector<std::optional<std::size_t>>;

std::string whole(const std::string& name) { return fs::path(name).lexically_normal().string(); }

/// Windows divides folders by '\\', which a name may hold elsewhere: there `whole` finds it.
fs::path path_of(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return fs::path(name).lexically_normal();
}

std::string file_name(const std::string& name) { return path_of(name).filename().string(); }

std::string file_name_with_folder(const std::string& name) {
    const fs::path path = path_of(name);
    return (path.parent_path().filename() / path.filename()).string();
}

std::string stem(const std::string& name) { return path_of(name).stem().string(); }

std::string last_word(const std::string& name) {
    const std::string file = file_name(name);
    return file.substr(file.find_last_of(' ') + 1);
}

struct ComparedParts {
    NamePart of_wanted;
    NamePart of_available;
};

/// The last but one: of "scan.0001" ".0001" is no ending, where the file is "scan.0001.png".
constexpr std::array<ComparedParts, 6> kWays{{{whole, whole},
                                              {file_name_with_folder, file_name_with_folder},
                                              {file_name, file_name},
                                              {stem, stem},
                                              {file_name, stem},
                                              {last_word, last_word}}};

/// The index of each part; none where two names share it.
std::map<std::string, std::optional<std::size_t>> index_by(NamePart part,
                                                           const std::vector<std::string>& names) {
    std::map<std::string, std::optional<std::size_t>> indices;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto [entry, is_new] = indices.emplace(part(names[i]), i);
        if (!is_new) entry->second.reset();
    }
    return indices;
}

Matches matches_by(const ComparedParts& parts, const std::vector<std::string>& wanted,
                   const std::vector<std::string>& available) {
    const auto available_by_part = index_by(parts.of_available, available);
    Matches matches(wanted.size());
    for (const auto& [key, index] : index_by(parts.of_wanted, wanted)) {
        const auto found = available_by_part.find(key);
        if (index && found != available_by_part.end()) matches[*index] = found->second;
    }
    return matches;
}

}  // namespace

Matches matched_names(const std::vector<std::string>& wanted,
                      const std::vector<std::string>& available) {
    Matches best(wanted.size());
    std::ptrdiff_t best_count = 0;
    for (const ComparedParts& parts : kWays) {
        Matches matches = matches_by(parts, wanted, available);
        const auto count = std::count_if(matches.begin(), matches.end(),
                                         [](const auto& match) { return match.has_value(); });
        if (count > best_count) {
            best = std::move(matches);
            best_count = count;
        }
    }
    return best;
}

}  // namespace lumi
