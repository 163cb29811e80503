#include "calib/work/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/set_variable.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

TEST(TemporaryFolder, IsOfOneAloneAndGoneWithAllThatIsInIt) {
    const ScratchFolder scratch;
    const SetVariable place("TMPDIR", scratch.path().string());
    {
        const TemporaryFolder one;
        const TemporaryFolder other;
        EXPECT_NE(one / "a", other / "a");
        EXPECT_EQ((one / "a").parent_path().parent_path(), scratch.path());
        write_whole_text(one / "a", "text");
        fs::create_directories(other / "b");
    }
    EXPECT_TRUE(fs::is_empty(scratch.path()));
}

TEST(TemporaryFolder, StandsWhereTemporaryFilesGoWhenTheirPlaceIsNone) {
    const ScratchFolder scratch;
    const SetVariable place("TMPDIR", (scratch / "missing").string());
    const TemporaryFolder folder;
    EXPECT_EQ((folder / "a").parent_path().parent_path(), "/tmp");
}

TEST(TemporaryFolder, HasAnAbsolutePath) {
    const SetVariable place("TMPDIR", ".");
    const TemporaryFolder folder;
    EXPECT_TRUE((folder / "a").is_absolute());
}

TEST(TemporaryFolder, RefusesWhereNoneCanBeMade) {
    if (!fs::is_directory("/proc")) GTEST_SKIP() << "no /proc here";
    const SetVariable place("TMPDIR", "/proc");
    try {
        const TemporaryFolder folder;
        ADD_FAILURE() << "expected a refusal";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-FILE-WRITE");
    }
}

}  // namespace
}  // namespace lumi
