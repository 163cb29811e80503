#include "pipeline/workspace/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"

namespace lumi {

void refuse_lock(const std::filesystem::path& folder, int error_number) {
    if (error_number == EWOULDBLOCK) {
        throw Error(ErrorKind::kBadInput, "E-WORKSPACE-BUSY",
                    folder.string() + ": another run of lumi works in this folder",
                    "wait until it has finished, or work in another folder");
    }
    // Some network file systems cannot lock. To work there all the same would let two runs remove
    // each other's unfinished files, unnoticed; another folder is soon named.
    throw Error(ErrorKind::kBadInput, "E-WORKSPACE-LOCK",
                folder.string() +
                    ": cannot be locked against other runs of lumi: " + std::strerror(error_number),
                "work in a folder on a disk of this machine");
}

FolderLock::FolderLock(const std::filesystem::path& folder) {
    std::error_code status;
    std::filesystem::create_directories(folder, status);
    if (status) refuse_write(folder, status.value());
    const std::filesystem::path path = folder / kLockName;
    // Close-on-exec: a program that outlives lumi must not keep the workspace.
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) refuse_write(path, errno);
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        const int reason = errno;
        ::close(descriptor_);
        refuse_lock(folder, reason);
    }
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace lumi
