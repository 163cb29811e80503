#pragma once

#include <filesystem>
#include <functional>

#include "pipeline/workspace/folder_lock.h"

namespace lumi {

/// A folder that is no workspace and holds what lumi makes on the way to a result, such as the
/// variants of a chart: marked as lumi's (made_by_lumi.h), so that no photographs are looked for in
/// it, and held by this process.
class WorkFolder {
 public:
    /// Makes the folder where there is none. One that is not marked has to be empty, or one that
    /// early versions left: such as `is_of_early_version` knows. Throws Error: E-OUT-EXISTS where
    /// it is somebody's or a package, E-WORKSPACE-BUSY, E-FILE-WRITE.
    WorkFolder(const std::filesystem::path& folder,
               const std::function<bool(const std::filesystem::path&)>& is_of_early_version);

 private:
    FolderLock lock_;
};

/// Whether there is a JSON file of lumi's at the path.
[[nodiscard]] bool is_record_of_lumi(const std::filesystem::path& path);

/// Whether a workspace lies in the folder.
[[nodiscard]] bool holds_workspace(const std::filesystem::path& folder);

}  // namespace lumi
