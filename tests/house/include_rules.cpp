#include "tests/house/include_rules.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <optional>
#include <regex>
#include <string_view>
#include <vector>

#include "tests/house/room_sources.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> kHandedOn{"calib/capture/", "calib/pictures/",
                                                    "meshing/surface/", "render/lumigraph/"};
constexpr std::array<std::string_view, 7> kHeavy{"opencv2/", "CGAL/",        "ceres/", "colmap/",
                                                 "nlohmann", "OpenImageIO/", "toml++"};

/// Of each room, in the order of kRooms, its chapters in the order in which they build upon each
/// other.
const std::array<std::vector<std::string_view>, kRooms.size()>& chapters_of_rooms() {
    static const std::array<std::vector<std::string_view>, kRooms.size()> kChapters{{
        {"work", "capture", "opencv", "pictures", "lens", "adjust", "ingest", "boards", "features",
         "colmap", "known_poses", "matching", "mapping", "doctor", "poses", "lens_files"},
        {"surface", "cameras", "rivals", "warp", "selection", "exposure", "depth_scene", "geometry",
         "matching", "agreement", "filling", "depth_models", "depth", "planning", "fusion",
         "transients"},
        {"lumigraph", "transfer",     "depth_mesh",   "faces", "depth_search", "view_choice",
         "frame",     "subdivision",  "surroundings", "holes", "gl",           "shaders",
         "uploaded",  "depth_layers", "painters",     "modes", "reference",    "rivals",
         "renderer",  "paths",        "bench",        "viewer"},
        {"text",   "config", "workspace", "synth",       "stages",     "evaluate",   "line",
         "report", "chart",  "protocol",  "target",      "dataset",    "regression", "gallery",
         "stress", "plan",   "bench",     "depth_bench", "pose_bench", "hazards",    "commands"},
    }};
    return kChapters;
}

/// Where a path's first part stands in the order of the rooms; empty for anything else.
std::optional<std::size_t> room_of(const std::string& path) {
    const std::string first = path.substr(0, path.find('/'));
    const auto* room = std::find(kRooms.begin(), kRooms.end(), first);
    if (room == kRooms.end()) return std::nullopt;
    return static_cast<std::size_t>(room - kRooms.begin());
}

/// Where a file stands in the order of its room; the number of chapters where its chapter is not in
/// that order.
struct Place {
    std::size_t room = 0;
    std::size_t chapter = 0;

    [[nodiscard]] bool is_known() const { return chapter < chapters_of_rooms()[room].size(); }
};

/// Empty for what is in no chapter of a room.
std::optional<Place> place_of(const std::string& path) {
    const std::size_t begin = path.find('/');
    const std::size_t end = path.find('/', begin + 1);
    const auto room = room_of(path);
    if (!room || end == std::string::npos) return std::nullopt;
    const std::vector<std::string_view>& names = chapters_of_rooms()[*room];
    const std::string name = path.substr(begin + 1, end - begin - 1);
    const auto chapter = std::find(names.begin(), names.end(), name);
    return Place{*room, static_cast<std::size_t>(chapter - names.begin())};
}

std::string offence(const IncludeLine& include, const std::string& why) {
    return include.file.generic_string() + ":" + std::to_string(include.line) + ": includes \"" +
           include.target + "\": " + why;
}

void append_includes(const fs::path& repository, const fs::path& file,
                     std::vector<IncludeLine>& includes) {
    static const std::regex kInclude(R"(^\s*#\s*include\s*["<]([^">]+)[">])");
    std::ifstream stream(file);
    std::string text;
    for (int line = 1; std::getline(stream, text); ++line) {
        std::smatch match;
        if (!std::regex_search(text, match, kInclude)) continue;
        includes.push_back({fs::relative(file, repository), line, match[1]});
    }
}

}  // namespace

std::vector<IncludeLine> include_lines_of_rooms(const fs::path& repository) {
    std::vector<IncludeLine> includes;
    for (const fs::path& file : room_sources(repository))
        append_includes(repository, file, includes);
    return includes;
}

Offences wrong_directions(const std::vector<IncludeLine>& includes) {
    Offences offences;
    for (const IncludeLine& include : includes) {
        const auto from = room_of(include.file.generic_string());
        const auto to = room_of(include.target);
        if (from && to && *to > *from) {
            offences.push_back(offence(include, std::string(kRooms[*from]) + " does not know " +
                                                    std::string(kRooms[*to])));
        }
        if (include.target.starts_with("tests/")) {
            offences.push_back(offence(include, "no room knows its tests"));
        }
    }
    return offences;
}

Offences chapters_that_look_ahead(const std::vector<IncludeLine>& includes) {
    Offences offences;
    for (const IncludeLine& include : includes) {
        const auto from = place_of(include.file.generic_string());
        const auto to = place_of(include.target);
        if (!from || !to || from->room != to->room) continue;
        const std::vector<std::string_view>& names = chapters_of_rooms()[from->room];
        if (!from->is_known() || !to->is_known())
            offences.push_back(offence(include, "a chapter without a place in the order"));
        else if (to->chapter > from->chapter)
            offences.push_back(offence(include, std::string(names[from->chapter]) +
                                                    " does not know " +
                                                    std::string(names[to->chapter])));
    }
    return offences;
}

Offences heavy_headers_handed_on(const std::vector<IncludeLine>& includes) {
    Offences offences;
    for (const IncludeLine& include : includes) {
        const std::string file = include.file.generic_string();
        const bool is_handed_on =
            include.file.extension() == ".h" &&
            std::any_of(kHandedOn.begin(), kHandedOn.end(),
                        [&](std::string_view folder) { return file.starts_with(folder); });
        const bool is_heavy = std::any_of(
            kHeavy.begin(), kHeavy.end(),
            [&](std::string_view prefix) { return include.target.starts_with(prefix); });
        if (is_handed_on && is_heavy) {
            offences.push_back(offence(include, "other rooms would have to compile it too"));
        }
    }
    return offences;
}

}  // namespace lumi
