#pragma once

#include <filesystem>

namespace lumi {

/// A file that stays where one was held.
inline constexpr const char* kLockName = ".lock";

/// Holds a folder for this process; the system lets go when the process ends, however it ends.
class FolderLock {
 public:
    /// Makes the folder where there is none. Throws Error: E-WORKSPACE-BUSY when another process
    /// holds it, E-WORKSPACE-LOCK when its file system cannot lock, E-FILE-WRITE when the folder or
    /// the lock file cannot be made.
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

 private:
    int descriptor_ = -1;
};

/// Throws the Error of a lock that was not given, for a value of errno.
[[noreturn]] void refuse_lock(const std::filesystem::path& folder, int error_number);

}  // namespace lumi
