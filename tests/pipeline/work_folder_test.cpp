#include "pipeline/workspace/work_folder.h"

#include <gtest/gtest.h>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Empty where the folder is given.
std::string refusal_of(const fs::path& folder) {
    try {
        const WorkFolder held(folder, {"chart.json"});
        return "";
    } catch (const Error& error) {
        return error.code();
    }
}

TEST(WorkFolder, IsMarkedAndHeldByOneRun) {
    const ScratchFolder scratch;
    const fs::path folder = scratch / "new/chart";
    {
        const WorkFolder held(folder, {"chart.json"});
        EXPECT_TRUE(is_marked_as_made_by_lumi(folder));
        EXPECT_EQ(refusal_of(folder), "E-WORKSPACE-BUSY");
    }
    write_whole_text(folder / "chart.svg", "");
    EXPECT_EQ(refusal_of(folder), "") << "a run before marked it";
}

TEST(WorkFolder, OneOfTheUsersOwnIsRefusedAndNotMarked) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "IMG_1.jpg", "the user's own");
    EXPECT_EQ(refusal_of(scratch.path()), "E-OUT-EXISTS");
    EXPECT_FALSE(is_made_by_lumi(scratch.path()));
}

TEST(WorkFolder, OneThatAnEarlyVersionLeftUnmarkedIsKnownByWhatItHolds) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "drawing.svg", "");
    write_whole_text(scratch / "chart.json", "{}");
    EXPECT_EQ(refusal_of(scratch.path()), "");
    EXPECT_TRUE(is_marked_as_made_by_lumi(scratch.path()));
}

}  // namespace
}  // namespace lumi
