#include "pipeline/workspace/stage_store.h"

#include <gtest/gtest.h>

#include <optional>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/workspace/stage_cache.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Two workspaces and a store between them.
class StageStoreTest : public testing::Test {
 protected:
    FinishedStage bring(const std::string& workspace_name, const std::string& parameters,
                        const fs::path& product = {}) {
        const Workspace workspace(WorkspaceLayout(scratch_ / workspace_name, "scene"));
        write_whole_text(workspace.config_path(), kWorkspaceConfigHeader);
        SilentProgress progress;
        const Stage stage{{"depth", "code", parameters, "", "inputs"},
                          [&](const fs::path& folder) -> StageEvidence {
                              ++runs_;
                              if (ends_) throw Error(*ends_);
                              write_whole_text(folder / "below" / "map.txt", "map " + parameters);
                              return {R"({"runs":1})", "{}"};
                          },
                          product};
        return bring_up_to_date(workspace, stage, 1, progress, &store_);
    }
    [[nodiscard]] fs::path map_in(const std::string& workspace_name) const {
        return scratch_ / workspace_name / "depth" / "below" / "map.txt";
    }

    ScratchFolder scratch_;
    StageStore store_{scratch_ / "store"};
    int runs_ = 0;
    std::optional<Error> ends_;
};

TEST_F(StageStoreTest, WhatOneWorkspaceMadeTheOtherTakes) {
    EXPECT_TRUE(bring("a", "x").was_run);
    const FinishedStage taken = bring("b", "x");
    EXPECT_FALSE(taken.was_run);
    EXPECT_EQ(runs_, 1);
    EXPECT_EQ(taken.evidence.facts_json, R"({"runs":1})");
    EXPECT_EQ(read_whole_text(map_in("b")), "map x");
    EXPECT_EQ(fs::hard_link_count(map_in("b")), 3U);  // Both workspaces and the store.
    EXPECT_FALSE(bring("b", "x").was_run);
}

TEST_F(StageStoreTest, OtherParametersAreAnotherResult) {
    static_cast<void>(bring("a", "x"));
    EXPECT_TRUE(bring("b", "y").was_run);
    EXPECT_EQ(read_whole_text(map_in("a")), "map x");
    // Going back costs nothing.
    EXPECT_FALSE(bring("b", "x").was_run);
    EXPECT_EQ(read_whole_text(map_in("b")), "map x");
    EXPECT_EQ(runs_, 2);
}

TEST_F(StageStoreTest, HarmedFilesAreNotTaken) {
    static_cast<void>(bring("a", "x"));
    for (const auto& entry : fs::recursive_directory_iterator(scratch_ / "store")) {
        if (entry.path().filename() != "map.txt") continue;
        fs::remove(entry.path());
        write_whole_text(entry.path(), "harmed");
        break;
    }
    EXPECT_TRUE(bring("b", "x").was_run);
    EXPECT_EQ(read_whole_text(map_in("b")), "map x");
    EXPECT_FALSE(bring("c", "x").was_run);  // And the store is mended.
}

TEST_F(StageStoreTest, WhatPhotographsCannotTellIsAskedOnce) {
    const auto code_for = [&](const std::string& workspace, const std::string& parameters) {
        try {
            return bring(workspace, parameters).name;
        } catch (const Error& error) {
            return error.code();
        }
    };
    ends_ = Error(ErrorKind::kDegenerateCapture, "E-POSES-NOISE", "noise", "");
    EXPECT_EQ(code_for("a", "x"), "E-POSES-NOISE");
    EXPECT_EQ(code_for("b", "x"), "E-POSES-NOISE");
    EXPECT_EQ(runs_, 1);
    EXPECT_EQ(code_for("b", "y"), "E-POSES-NOISE");
    EXPECT_EQ(runs_, 2) << "other parameters may tell more";
    ends_ = Error(ErrorKind::kResources, "E-MEMORY", "memory ran out", "");
    EXPECT_EQ(code_for("a", "z"), "E-MEMORY");
    ends_.reset();
    EXPECT_EQ(code_for("b", "z"), "depth") << "the machine may have had a bad moment";
}

TEST_F(StageStoreTest, AStageWithAProductElsewhereIsNotShared) {
    write_whole_text(scratch_.path() / "a" / "config.toml", kWorkspaceConfigHeader);
    write_whole_text(scratch_.path() / "a" / "scene.lumi" / "file", "x");
    static_cast<void>(bring("a", "x", scratch_.path() / "a" / "scene.lumi"));
    EXPECT_TRUE(bring("b", "x").was_run);
}

}  // namespace
}  // namespace lumi
