#pragma once

#include <filesystem>

namespace lumi {

/// Holds a folder for this process; the system lets go when the process ends, however it ends.
class FolderLock {
 public:
    /// Throws Error (E-WORKSPACE-BUSY) when another process holds it, E-FILE-WRITE when the lock
    /// file cannot be made.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

 private:
    int descriptor_ = -1;
};

}  // namespace lumi
