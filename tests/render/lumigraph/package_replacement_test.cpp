#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/render/lumigraph/tiny_package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::size_t entries_in(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A disk that takes no file longer than `bytes`, for as long as this lives.
class ShortFiles {
 public:
    explicit ShortFiles(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_limit_);
        const rlimit limit{bytes, old_limit_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~ShortFiles() {
        ::setrlimit(RLIMIT_FSIZE, &old_limit_);
        std::signal(SIGXFSZ, old_handler_);
    }
    ShortFiles(const ShortFiles&) = delete;
    ShortFiles& operator=(const ShortFiles&) = delete;

 private:
    rlimit old_limit_{};
    void (*old_handler_)(int);
};

class PackageReplacement : public testing::Test {
 protected:
    void SetUp() override { write_package(folder_, old_, tiny_extras()); }

    ScratchFolder scratch_;
    fs::path folder_ = scratch_ / "tiny.lumi";
    Lumigraph old_ = tiny_lumigraph(1);
    Lumigraph new_ = tiny_lumigraph(2);
};

TEST_F(PackageReplacement, PutsTheNewPackageInThePlaceOfTheOld) {
    new_.views.resize(2);
    new_.mesh.vertices.resize(2);
    new_.mesh.faces.clear();
    write_package(folder_, new_, tiny_extras());
    EXPECT_EQ(read_package(folder_).views[0].photograph, new_.views[0].photograph);
    EXPECT_FALSE(fs::exists(folder_ / "views/000003.png")) << "a file of the old package stayed";
    EXPECT_EQ(entries_in(scratch_.path()), 1U);
}

TEST_F(PackageReplacement, TakesATrailingSlash) {
    write_package(folder_.string() + "/", new_, tiny_extras());
    EXPECT_EQ(read_package(folder_).views[0].photograph, new_.views[0].photograph);
    EXPECT_EQ(entries_in(scratch_.path()), 1U);
}

TEST_F(PackageReplacement, AFailingWriteLeavesTheOldPackage) {
    int failures = 0;
    for (const rlim_t bytes : {0U, 50U, 100U, 200U, 400U, 1000U, 3000U}) {
        try {
            const ShortFiles disk(bytes);
            write_package(folder_, new_, tiny_extras());
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), "E-FILE-WRITE");
            EXPECT_EQ(read_package(folder_).views[0].photograph, old_.views[0].photograph);
            ++failures;
        }
        EXPECT_EQ(entries_in(scratch_.path()), 1U) << "something was left behind";
    }
    EXPECT_GE(failures, 5);
}

TEST_F(PackageReplacement, AKilledRunLeavesTheOldPackageAndIsCleanedUpAfter) {
    const pid_t child = ::fork();
    if (child == 0) {
        // Dies of the signal in the middle of a file: no destructor runs. That leaves no core.
        const rlimit no_core{0, 0};
        ::setrlimit(RLIMIT_CORE, &no_core);
        const rlimit limit{300, RLIM_INFINITY};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        std::signal(SIGXFSZ, SIG_DFL);
        write_package(folder_, new_, tiny_extras());
        ::_exit(0);
    }
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(read_package(folder_).views[0].photograph, old_.views[0].photograph);
    EXPECT_EQ(entries_in(scratch_.path()), 2U) << "expected the remains of the killed run";

    write_package(folder_, new_, tiny_extras());
    EXPECT_EQ(read_package(folder_).views[0].photograph, new_.views[0].photograph);
    EXPECT_EQ(entries_in(scratch_.path()), 1U);
}

TEST_F(PackageReplacement, AReaderFindsAWholePackageWhileItIsReplaced) {
    std::jthread writer([&](const std::stop_token& stop) {
        for (unsigned seed = 2; !stop.stop_requested(); ++seed) {
            write_package(folder_, tiny_lumigraph(seed), tiny_extras());
        }
    });
    // The reader holds the folder open: it sees the old files or the new ones, or learns that the
    // ones it began with are gone. It never mixes them.
    int whole = 0;
    for (int attempt = 0; attempt < 300; ++attempt) {
        const std::string code = code_of_reading(folder_);
        EXPECT_TRUE(code.empty() || code == "E-PACKAGE-MISSING") << code;
        whole += code.empty() ? 1 : 0;
        EXPECT_TRUE(fs::exists(folder_));
    }
    EXPECT_GT(whole, 0);
}

TEST_F(PackageReplacement, NeverReplacesAFolderThatIsNoPackage) {
    write_whole_text(scratch_ / "holiday/photo.jpg", "precious");
    EXPECT_THROW(write_package(scratch_ / "holiday", new_, tiny_extras()), Error);
    EXPECT_THROW(write_package(scratch_ / "holiday/photo.jpg", new_, tiny_extras()), Error);
    EXPECT_EQ(read_whole_text(scratch_ / "holiday/photo.jpg"), "precious");
}

TEST_F(PackageReplacement, KeepsWhatSomebodyPutIntoThePackage) {
    for (const char* name : {"screenshot-1.png", "views/000001.jpg", "views/1.png", "mine/a.txt"})
        write_whole_text(folder_ / name, "the user's own");
    write_package(folder_, new_, tiny_extras());
    for (const char* name : {"screenshot-1.png", "views/000001.jpg", "views/1.png", "mine/a.txt"})
        EXPECT_EQ(read_whole_text(folder_ / name), "the user's own") << name;
    EXPECT_EQ(read_package(folder_).views[0].photograph, new_.views[0].photograph);
}

TEST_F(PackageReplacement, KnowsTheNamesOfAllThatAPackageHolds) {
    int files = 0;
    for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
        if (!entry.is_regular_file()) continue;
        const std::string name = entry.path().lexically_relative(folder_).generic_string();
        EXPECT_TRUE(is_name_in_package(name)) << name;
        ++files;
    }
    EXPECT_GT(files, 4);
    for (const char* name : {"notes.txt", "views/1.png", "views/000000.png", "views/000001.jpg",
                             "depth/000001.txt", "000001.png", "views/", ""})
        EXPECT_FALSE(is_name_in_package(name)) << name;
    EXPECT_TRUE(is_name_in_package("depth/000012.mesh"));
    EXPECT_TRUE(is_name_in_package("views/1234567.png"));
}

}  // namespace
}  // namespace lumi
