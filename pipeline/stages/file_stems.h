#pragma once

#include <string>
#include <vector>

namespace lumi {

/// File names for views: the view's name without its ending, in letters that every file system and
/// page carries, unique. "b/IMG 1.jpg" becomes "b_IMG_1".
[[nodiscard]] std::vector<std::string> file_stems_of_views(const std::vector<std::string>& names);

/// The same where a dot tells what a view's file shows: views IMG.jpg and IMG.flip.jpg may each
/// have an IMG.flip.png otherwise.
[[nodiscard]] std::vector<std::string> file_stems_without_dots(std::vector<std::string> names);

}  // namespace lumi
