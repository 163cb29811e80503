#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lumi {

/// One `#include` line of one file.
struct IncludeLine {
    std::filesystem::path file;  ///< Relative to the repository.
    int line = 0;                ///< From 1.
    std::string target;          ///< What stands between the quotes or brackets.
};

/// An include that breaks a rule, in words: "calib/x.h:3: includes "render/y.h": why not".
using Offences = std::vector<std::string>;

/// The include lines of every .h, .cpp, .inc and .in file below the rooms of a repository, in order
/// of their paths.
[[nodiscard]] std::vector<IncludeLine> include_lines_of_rooms(
    const std::filesystem::path& repository);

/// A room includes itself and the rooms before it: calib <- meshing <- render <- pipeline; and no
/// room includes tests.
[[nodiscard]] Offences wrong_directions(const std::vector<IncludeLine>& includes);

/// A chapter, the folder of a room, includes itself and the chapters before it, in the order in
/// which they build upon each other: none ends in a circle. A chapter without a place in that order
/// is an offence, too.
[[nodiscard]] Offences chapters_that_look_ahead(const std::vector<IncludeLine>& includes);

/// The headers that rooms hand on keep OpenCV, CGAL, Ceres and the like to themselves.
[[nodiscard]] Offences heavy_headers_handed_on(const std::vector<IncludeLine>& includes);

}  // namespace lumi
