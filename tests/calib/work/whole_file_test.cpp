#include "calib/work/whole_file.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "calib/work/error.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

std::size_t files_in(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

/// Files beyond `bytes` cannot be written while this lives: the file system says EFBIG.
class FileSizeLimit {
 public:
    explicit FileSizeLimit(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_limit_);
        rlimit limit = old_limit_;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &old_limit_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
    void (*old_handler_)(int);
    rlimit old_limit_{};
};

TEST(WholeFile, ReadsBackWhatItWroteAndLeavesNothingElse) {
    const ScratchFolder scratch;
    Bytes bytes(100000);
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * i);
    write_whole_file(scratch / "a/b/file.bin", bytes);
    EXPECT_EQ(read_whole_file(scratch / "a/b/file.bin"), bytes);
    write_whole_text(scratch / "a/b/file.bin", "shorter");
    EXPECT_EQ(read_whole_text(scratch / "a/b/file.bin"), "shorter");
    write_whole_text(scratch / "a/b/file.bin", "");
    EXPECT_EQ(read_whole_text(scratch / "a/b/file.bin"), "");
    EXPECT_EQ(files_in(scratch / "a/b"), 1U);
}

TEST(WholeFile, MayBeReadByWhomTheProcessLets) {
    const ScratchFolder scratch;
    for (const mode_t mask : {mode_t{077}, mode_t{002}}) {
        const mode_t before = ::umask(mask);
        write_whole_text(scratch / "file.txt", "text");
        ::umask(before);
        EXPECT_EQ(std::filesystem::status(scratch / "file.txt").permissions(),
                  std::filesystem::perms(0666 & ~mask));
    }
}

TEST(WholeFile, RemovesWhatKilledRunsLeftBesideAFileAndNothingElse) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "config.toml", "whole");
    write_whole_text(scratch / ".config.toml.new-a1B2c3", "half");
    write_whole_text(scratch / "config.toml.backup", "the user's own");
    write_whole_text(scratch / ".other.toml.new-a1B2c3", "another file's");
    remove_unfinished_siblings(scratch / "config.toml");
    EXPECT_EQ(files_in(scratch.path()), 3U);
    EXPECT_FALSE(std::filesystem::exists(scratch / ".config.toml.new-a1B2c3"));
}

TEST(WholeFile, TextIsReadWithoutAByteOrderMark) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "windows.txt", "\xEF\xBB\xBF# cameras\n");
    EXPECT_EQ(read_whole_text(scratch / "windows.txt"), "# cameras\n");
    EXPECT_EQ(read_whole_file(scratch / "windows.txt").size(), 13U) << "bytes are bytes";
    write_whole_text(scratch / "short.txt", "\xEF\xBB");
    EXPECT_EQ(read_whole_text(scratch / "short.txt"), "\xEF\xBB");
}

TEST(WholeFile, PutsWhatAnotherProgramMadeInPlace) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "video.mp4", "old");
    write_whole_text(scratch / "made/video.mp4", "new");
    put_whole_file(scratch / "made/video.mp4", scratch / "video.mp4");
    EXPECT_EQ(read_whole_text(scratch / "video.mp4"), "new");
    EXPECT_THROW(put_whole_file(scratch / "made/video.mp4", scratch / "video.mp4"), Error);
    EXPECT_EQ(read_whole_text(scratch / "video.mp4"), "new");
}

TEST(WholeFile, WhatCannotBeWrittenIsRefusedBeforehand) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "file.txt", "what was there");
    EXPECT_NO_THROW(require_writable_file(scratch / "file.txt"));
    EXPECT_NO_THROW(require_writable_file(scratch / "new/folder/file.txt"));
    EXPECT_NO_THROW(require_writable_folder(scratch.path()));
    EXPECT_NO_THROW(require_writable_folder(scratch / "new/folder/"));
    EXPECT_THROW(require_writable_file(scratch.path()), Error);
    EXPECT_THROW(require_writable_file(scratch / "new/"), Error);
    EXPECT_THROW(require_writable_file(scratch / "file.txt/file.txt"), Error);
    EXPECT_THROW(require_writable_folder(scratch / "file.txt"), Error);
    EXPECT_THROW(require_writable_folder(scratch / "file.txt/new/folder"), Error);
    EXPECT_EQ(files_in(scratch.path()), 1U) << "asking has made something";
    EXPECT_EQ(read_whole_text(scratch / "file.txt"), "what was there");
}

/// As somebody who is not root, in a child process: whether a folder without the right to write in
/// it is refused.
bool refuses_without_the_right(const std::filesystem::path& folder) {
    const pid_t child = ::fork();
    if (child == 0) {
        constexpr uid_t kNobody = 65534;
        if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(2);
        try {
            require_writable_file(folder / "file.txt");
        } catch (const Error& error) {
            ::_exit(error.code() == "E-FILE-WRITE" ? 0 : 3);
        }
        ::_exit(1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(WholeFile, AFolderThatOnlyOthersMayWriteInIsRefusedBeforehand) {
    const ScratchFolder scratch;
    std::filesystem::create_directory(scratch / "theirs");
    std::filesystem::permissions(scratch.path(), std::filesystem::perms{0755});
    std::filesystem::permissions(scratch / "theirs", std::filesystem::perms{0555});
    EXPECT_TRUE(refuses_without_the_right(scratch / "theirs"));
}

TEST(WholeFile, WhatWasThereSurvivesAWriteThatFails) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "file.txt", "what was there");
    const Bytes too_large(100000, 7);
    {
        const FileSizeLimit limit(50000);
        try {
            write_whole_file(scratch / "file.txt", too_large);
            FAIL();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-FILE-WRITE");
            EXPECT_EQ(error.kind(), ErrorKind::kResources);
        }
    }
    EXPECT_EQ(read_whole_text(scratch / "file.txt"), "what was there");
    EXPECT_EQ(files_in(scratch.path()), 1U) << "the temporary file is left behind";
}

enum ChildExit : int { kRefusedAsFull = 0, kWroteAll = 1, kOtherError = 2, kCannotMount = 3 };

/// Runs in a child process: a mount of its own would outlive a test that crashes.
int write_to_a_full_disk(const std::filesystem::path& folder) {
    if (::unshare(CLONE_NEWNS) != 0 ||
        ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0 ||
        ::mount("tmpfs", folder.c_str(), "tmpfs", 0, "size=64k") != 0) {
        return kCannotMount;
    }
    try {
        write_whole_file(folder / "file.bin", Bytes(1 << 20, 7));
    } catch (const Error& error) {
        const bool refused = error.kind() == ErrorKind::kResources &&
                             error.code() == "E-FILE-WRITE" && files_in(folder) == 0;
        return refused ? kRefusedAsFull : kOtherError;
    }
    return kWroteAll;
}

TEST(WholeFile, AFullDiskIsRefusedAsSuch) {
    const ScratchFolder scratch;
    const pid_t child = ::fork();
    if (child == 0) ::_exit(write_to_a_full_disk(scratch.path()));
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFEXITED(status));
    if (WEXITSTATUS(status) == kCannotMount) GTEST_SKIP() << "mounting a small disk needs root";
    EXPECT_EQ(WEXITSTATUS(status), kRefusedAsFull);
}

TEST(WholeFile, RefusesFoldersAbsentFilesAndFilesBeyondTheLimit) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "file.txt", "12345678");
    const auto code = [&](const std::filesystem::path& path, std::size_t max_bytes) -> std::string {
        try {
            static_cast<void>(read_whole_file(path, max_bytes));
        } catch (const Error& error) {
            return error.code();
        }
        return "none";
    };
    EXPECT_EQ(code(scratch / "file.txt", 8), "none");
    EXPECT_EQ(code(scratch / "file.txt", 7), "E-FILE-TOOBIG");
    EXPECT_EQ(code(scratch / "absent.txt", 8), "E-FILE-READ");
    EXPECT_EQ(code(scratch.path(), 8), "E-FILE-READ");
    EXPECT_EQ(code("/dev/zero", 8), "E-FILE-READ");
    EXPECT_THROW(write_whole_text(scratch / "file.txt/below", ""), Error);
}

}  // namespace
}  // namespace lumi
