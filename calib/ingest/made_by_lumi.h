#pragma once

#include <filesystem>
#include <string>

namespace lumi {

/// Whether all that lies in the folder is lumi's: a package, a workspace, or a folder that was
/// marked.
[[nodiscard]] bool is_made_by_lumi(const std::filesystem::path& folder);

/// Whether a file of this name is such a mark.
[[nodiscard]] bool is_mark_of_lumi(const std::string& file_name);

/// Whether the folder was marked, whatever else speaks for it.
[[nodiscard]] bool is_marked_as_made_by_lumi(const std::filesystem::path& folder);

/// Leaves a hidden file in the folder that says so, for work that keeps pictures in a folder that
/// is none of the others. To be called before the first of them. The folder is made where there is
/// none. Throws Error (E-FILE-WRITE).
void mark_as_made_by_lumi(const std::filesystem::path& folder);

}  // namespace lumi
