#include "pipeline/workspace/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "calib/work/error.h"

namespace lumi {

FolderLock::FolderLock(const std::filesystem::path& folder) {
    const std::filesystem::path path = folder / ".lock";
    // Close-on-exec: a program that outlives lumi must not keep the workspace.
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) {
        throw Error(ErrorKind::kBadInput, "E-FILE-WRITE",
                    path.string() + ": cannot write: " + std::strerror(errno),
                    "check that the folder exists and that you may write there");
    }
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
        ::close(descriptor_);
        throw Error(ErrorKind::kResources, "E-WORKSPACE-BUSY",
                    folder.string() + ": another run of lumi works in this workspace",
                    "wait until it has finished, or choose another folder with --workspace");
    }
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace lumi
