#include "pipeline/workspace/work_folder.h"

#include <gtest/gtest.h>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/chart_folder.h"
#include "pipeline/workspace/workspace.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

bool has_chart(const fs::path& folder) { return fs::exists(folder / "chart.json"); }

/// Empty where the folder is given.
std::string refusal_of(const fs::path& folder) {
    try {
        const WorkFolder held(folder, has_chart);
        return "";
    } catch (const Error& error) {
        return error.code();
    }
}

TEST(WorkFolder, IsMarkedAndHeldByOneRun) {
    const ScratchFolder scratch;
    const fs::path folder = scratch / "new/chart";
    {
        const WorkFolder held(folder, has_chart);
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

TEST(WorkFolder, AUsersFolderIsNoChartsBecauseOfTheNamesInIt) {
    const ScratchFolder scratch;
    const auto refusal = [&] {
        try {
            const WorkFolder held = take_chart_folder(scratch.path());
            return std::string();
        } catch (const Error& error) {
            return error.code();
        }
    };
    write_whole_text(scratch / "variants/a/IMG_1.jpg", "the user's own");
    write_whole_text(scratch / "growth/config.toml", "name = \"the user's own\"");
    write_whole_text(scratch / "chart.json", R"({"type": "bar"})");
    EXPECT_EQ(refusal(), "E-OUT-EXISTS");
    EXPECT_FALSE(is_made_by_lumi(scratch.path()));
    write_whole_text(scratch / "variants/b/config.toml", kWorkspaceConfigHeader);
    EXPECT_EQ(refusal(), "") << "an early version was interrupted there";
}

TEST(WorkFolder, APackageIsNone) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "x.lumi/lumigraph.json", "{}");
    EXPECT_EQ(refusal_of(scratch / "x.lumi"), "E-OUT-EXISTS");
    EXPECT_FALSE(is_marked_as_made_by_lumi(scratch / "x.lumi"));
}

}  // namespace
}  // namespace lumi
