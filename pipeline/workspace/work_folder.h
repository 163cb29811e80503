#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pipeline/workspace/folder_lock.h"

namespace lumi {

/// A folder that is no workspace and holds what lumi makes on the way to a result, such as the
/// variants of a chart: marked as lumi's (made_by_lumi.h), so that no photographs are looked for in
/// it, and held by this process.
class WorkFolder {
 public:
    /// Makes the folder where there is none. One that is not marked has to be empty, or to hold
    /// something of the `known` names, by which early versions left it. Throws Error: E-OUT-EXISTS
    /// where it is somebody's, E-WORKSPACE-BUSY, E-FILE-WRITE.
    WorkFolder(const std::filesystem::path& folder, const std::vector<std::string>& known);

 private:
    FolderLock lock_;
};

}  // namespace lumi
