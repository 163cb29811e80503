#include "pipeline/workspace/stage_cache.h"

#include <gtest/gtest.h>

#include <chrono>
#include <set>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/workspace/stage_outputs.h"
#include "tests/calib/noted_progress.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// A workspace and a stage that copies one input, counting its runs.
class StageCache : public testing::Test {
 protected:
    StageCache() { write_whole_text(input_, "content"); }

    FinishedStage bring(const std::string& parameters = "width = 1") {
        const Workspace workspace(WorkspaceLayout(scratch_ / "work", "scene"));
        write_whole_text(workspace.config_path(), kWorkspaceConfigHeader);
        SilentProgress progress;
        return bring_up_to_date(workspace, copying_stage(parameters), 1, progress);
    }

    Stage copying_stage(const std::string& parameters) {
        return {{"mesh", "code", parameters, "", sha256_of_content(content_of(input_, 1))},
                [this, parameters](const fs::path& folder) -> StageEvidence {
                    ++runs_;
                    if (fails_) {
                        write_whole_text(folder / "half.txt", "half");
                        throw Error(ErrorKind::kBadInput, "E-TEST", "fails", "");
                    }
                    write_whole_text(folder / "copy.txt", read_whole_text(input_) + parameters);
                    return {R"({"runs": 1})", "{}"};
                },
                {}};
    }

    [[nodiscard]] std::set<std::string> names_in_workspace() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(scratch_ / "work")) {
            names.insert(entry.path().filename().string());
        }
        return names;
    }
    [[nodiscard]] fs::path copy_path() const { return scratch_ / "work" / "mesh" / "copy.txt"; }

    ScratchFolder scratch_;
    fs::path input_ = scratch_ / "input.txt";
    int runs_ = 0;
    bool fails_ = false;
};

TEST_F(StageCache, AFinishedStageIsNotRunAgain) {
    EXPECT_TRUE(bring().was_run);
    const FinishedStage again = bring();
    EXPECT_FALSE(again.was_run);
    EXPECT_EQ(runs_, 1);
    ASSERT_EQ(again.outputs.size(), 1U);
    EXPECT_EQ(again.outputs[0].name, "mesh/copy.txt");
    EXPECT_EQ(again.evidence.facts_json, R"({"runs":1})");
}

TEST_F(StageCache, AFinishedStageWarnsAgain) {
    const Workspace workspace(WorkspaceLayout(scratch_ / "work", "scene"));
    write_whole_text(workspace.config_path(), kWorkspaceConfigHeader);
    Stage stage = copying_stage("");
    stage.run = [](const fs::path&) -> StageEvidence {
        return {R"({"warnings": ["the zoom changed"]})", "{}"};
    };
    NotedProgress progress;
    static_cast<void>(bring_up_to_date(workspace, stage, 1, progress));
    EXPECT_EQ(progress.notes.size(), 1U);
    static_cast<void>(bring_up_to_date(workspace, stage, 1, progress));
    EXPECT_EQ(progress.notes.back(), "the zoom changed");
}

TEST_F(StageCache, AnotherFileTimeIsNoReasonToRun) {
    static_cast<void>(bring());
    fs::last_write_time(input_, fs::file_time_type::clock::now() + std::chrono::hours(1));
    fs::last_write_time(copy_path(), fs::file_time_type::clock::now() - std::chrono::hours(1));
    EXPECT_FALSE(bring().was_run);
}

TEST_F(StageCache, ChangedContentIsAReasonToRun) {
    static_cast<void>(bring());
    write_whole_text(input_, "other content");
    const FinishedStage again = bring();
    EXPECT_TRUE(again.was_run);
    EXPECT_EQ(again.reason, "inputs changed");
    EXPECT_EQ(read_whole_text(copy_path()), "other contentwidth = 1");
}

TEST_F(StageCache, ChangedParametersAreAReasonToRun) {
    static_cast<void>(bring());
    const FinishedStage again = bring("width = 2");
    EXPECT_TRUE(again.was_run);
    EXPECT_EQ(again.reason, "parameters changed");
}

TEST_F(StageCache, AnOutputThatWasHarmedIsMadeAgain) {
    static_cast<void>(bring());
    write_whole_text(copy_path(), "Content");
    EXPECT_TRUE(bring().was_run);
    EXPECT_EQ(read_whole_text(copy_path()), "contentwidth = 1");
    fs::remove(copy_path());
    EXPECT_TRUE(bring().was_run);
    EXPECT_EQ(runs_, 3);
}

TEST_F(StageCache, ADamagedMarkerIsNoMarker) {
    static_cast<void>(bring());
    const fs::path marker = scratch_ / "work" / "mesh" / "done.json";
    const std::string text = read_whole_text(marker);
    for (const std::size_t length : {std::size_t{0}, text.size() / 2, text.size() - 3}) {
        write_whole_text(marker, text.substr(0, length));
        EXPECT_TRUE(bring().was_run) << "cut to " << length;
    }
}

TEST_F(StageCache, AFailingStageLeavesTheFormerResultAndNothingHalf) {
    static_cast<void>(bring());
    fails_ = true;
    EXPECT_THROW(bring("width = 2"), Error);
    EXPECT_EQ(read_whole_text(copy_path()), "contentwidth = 1");
    EXPECT_EQ(names_in_workspace(), (std::set<std::string>{".lock", "config.toml", "mesh"}));
    fails_ = false;
    EXPECT_FALSE(bring().was_run);
}

TEST_F(StageCache, WhatAKilledRunLeftIsCleanedUp) {
    static_cast<void>(bring());
    const fs::path work = scratch_ / "work";
    write_whole_text(work / ".depth.new-a1B2c3" / "half.tif", "half");
    write_whole_text(work / ".scene.lumi.new-a1B2c3" / "lumigraph.json", "half");
    write_whole_text(work / ".stages.json.new-a1B2c3", "half");
    write_whole_text(work / "notes.txt", "the user's own");
    write_whole_text(work / "config.toml.backup", "the user's own");
    static_cast<void>(bring());
    EXPECT_EQ(names_in_workspace(), (std::set<std::string>{".lock", "config.toml", "mesh",
                                                           "notes.txt", "config.toml.backup"}));
}

/// The folder is refused and left as it is.
void expect_foreign(const fs::path& folder, const fs::path& file) {
    const std::string before = read_whole_text(folder / file);
    try {
        const Workspace workspace(WorkspaceLayout(folder, "scene"));
        FAIL() << file << " would be lost";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-WORKSPACE-FOREIGN");
    }
    EXPECT_EQ(read_whole_text(folder / file), before);
}

TEST_F(StageCache, AFolderOfOtherThingsIsNoWorkspace) {
    for (const char* name : {"depth/0001.exr", "evaluation/scores.txt", "config.toml",
                             "report.html", "scene.lumi/notes.txt"}) {
        const ScratchFolder dataset;
        write_whole_text(dataset / name, "the user's own");
        expect_foreign(dataset.path(), name);
    }
    const ScratchFolder photographs;
    write_whole_text(photographs / "images/0001.jpg", "the user's own");
    EXPECT_NO_THROW(Workspace(WorkspaceLayout(photographs.path(), "scene")));
}

TEST_F(StageCache, WhatLiesBesideALockAloneIsNotLumisOwn) {
    for (const char* name : {"config.toml", "stages.json", "report.html"}) {
        const ScratchFolder dataset;
        write_whole_text(dataset / kLockName, "");
        write_whole_text(dataset / name, "the user's own");
        expect_foreign(dataset.path(), name);
    }
    const ScratchFolder dataset;
    write_whole_text(dataset / kLockName, "");
    write_whole_text(dataset / "depth" / "0001.exr", "the user's own");
    expect_foreign(dataset.path(), "depth/0001.exr");
    fs::remove(dataset / "depth" / "0001.exr");
    EXPECT_NO_THROW(Workspace(WorkspaceLayout(dataset.path(), "scene")));
    write_whole_text(dataset / "depth" / kDoneMarkerName, "{}");
    EXPECT_NO_THROW(Workspace(WorkspaceLayout(dataset.path(), "scene")));
}

TEST_F(StageCache, AFolderIsLumisOwnByItsOwnMarkerAlone) {
    const ScratchFolder dataset;
    write_whole_text(dataset / "config.toml", kWorkspaceConfigHeader);
    write_whole_text(dataset / "depth" / kPlanName, "{}");
    expect_foreign(dataset.path(), fs::path("depth") / kPlanName);
}

TEST_F(StageCache, AStageWithoutMarkerIsLumisOwnWhateverTheLastRunWroteDown) {
    static_cast<void>(bring());
    for (const char* run : {"damaged", R"({"stages": []})", R"({"stages": [{"name": "mesh"}]})"}) {
        write_whole_text(scratch_ / "work/stages.json", run);
        fs::remove(scratch_ / "work/mesh" / kDoneMarkerName);
        EXPECT_TRUE(bring().was_run) << run;
    }
    EXPECT_EQ(runs_, 4);
    EXPECT_EQ(content_of(scratch_ / "work/mesh", 1).size(), 2U) << "the copy and the marker";
}

TEST_F(StageCache, AFolderThatTookTheNameOfAStageIsNotLumisOwn) {
    static_cast<void>(bring());
    write_whole_text(scratch_ / "work/stages.json", R"({"stages": [{"name": "mesh"}]})");
    fs::remove_all(scratch_ / "work/mesh");
    write_whole_text(scratch_ / "work/mesh/notes.txt", "the user's own");
    expect_foreign(scratch_ / "work", "mesh/notes.txt");
}

constexpr const char* kRecordOfRuns =
    R"({"schema_version": 1, "stages": [], "configuration_sha256": "a"})";

TEST_F(StageCache, AWorkspaceIsKnownThoughItsConfigurationWasEditedOrConverted) {
    const fs::path work = scratch_ / "work";
    const auto expect_known = [&] {
        EXPECT_NO_THROW(Workspace(WorkspaceLayout(work, "scene")));
        EXPECT_EQ(find_workspace(work).name(), "cat");
    };
    static_cast<void>(bring());
    write_whole_text(work / "config.toml",
                     std::string(kWorkspaceConfigHeader) + "\r\nname = \"cat\"\r\n");
    expect_known();
    write_whole_text(work / "stages.json", kRecordOfRuns);
    write_whole_text(work / "config.toml", "name = \"cat\"\n");
    expect_known();
    fs::remove(work / "mesh" / kDoneMarkerName);
    expect_foreign(work, "config.toml");
    EXPECT_THROW(static_cast<void>(find_workspace(work)), Error);
}

TEST_F(StageCache, NobodyIsToldToRemoveAConfiguration) {
    write_whole_text(scratch_ / "config.toml", "name = \"the user's own\"");
    try {
        const Workspace workspace(WorkspaceLayout(scratch_.path(), "scene"));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-WORKSPACE-FOREIGN");
        EXPECT_EQ(error.advice().find("remove"), std::string::npos) << error.advice();
    }
}

TEST_F(StageCache, AProductThatHoldsFilesOfTheUsersIsLeftToItsWriter) {
    const fs::path product = scratch_ / "work" / "scene.lumi";
    bool stood = false;
    const auto pack = [&](const std::string& parameters) {
        const Workspace workspace(WorkspaceLayout(scratch_ / "work", "scene"));
        write_whole_text(workspace.config_path(), kWorkspaceConfigHeader);
        SilentProgress progress;
        const Stage stage{{"pack", "code", parameters, "", "inputs"},
                          [&](const fs::path&) -> StageEvidence {
                              stood = fs::exists(product);
                              write_whole_text(product / "manifest.txt", parameters);
                              return {"{}", "{}"};
                          },
                          product};
        static_cast<void>(bring_up_to_date(workspace, stage, 1, progress));
    };
    pack("width = 1");
    fs::remove_all(product);
    write_whole_text(product / "below" / "notes.txt", "the user's own");
    pack("width = 2");
    EXPECT_TRUE(stood);
    EXPECT_EQ(read_whole_text(product / "below" / "notes.txt"), "the user's own");
}

TEST_F(StageCache, WhatSomebodyPutBesideTheOutputsIsKeptAndNoOutput) {
    static_cast<void>(bring());
    const fs::path notes = scratch_ / "work/mesh/mine/notes.txt";
    write_whole_text(notes, "the user's own");
    EXPECT_FALSE(bring().was_run);
    const FinishedStage again = bring("width = 2");
    EXPECT_TRUE(again.was_run);
    EXPECT_EQ(read_whole_text(notes), "the user's own");
    ASSERT_EQ(again.outputs.size(), 1U);
    EXPECT_EQ(again.outputs[0].name, "mesh/copy.txt");
}

TEST_F(StageCache, WhatSomebodyPutIntoTheProductIsNoOutput) {
    const fs::path product = scratch_ / "work" / "scene.lumi";
    const auto pack = [&](const std::string& parameters) {
        const Workspace workspace(WorkspaceLayout(scratch_ / "work", "scene"));
        write_whole_text(workspace.config_path(), kWorkspaceConfigHeader);
        SilentProgress progress;
        const Stage stage{{"pack", "code", parameters, "", "inputs"},
                          [&](const fs::path&) -> StageEvidence {
                              write_whole_text(product / "manifest.txt", parameters);
                              return {"{}", "{}"};
                          },
                          product,
                          [](const std::string& name) { return name == "manifest.txt"; }};
        return bring_up_to_date(workspace, stage, 1, progress);
    };
    static_cast<void>(pack("width = 1"));
    write_whole_text(product / "screenshot.png", "the user's own");
    ASSERT_EQ(pack("width = 2").outputs.size(), 1U);
    fs::remove(product / "screenshot.png");
    EXPECT_FALSE(pack("width = 2").was_run) << "it may come and go";
}

TEST_F(StageCache, AHarmedProductGivesWayWhateverElseChanged) {
    const fs::path product = scratch_ / "work" / "scene.lumi";
    const auto pack = [&](const std::string& parameters) {
        const Workspace workspace(WorkspaceLayout(scratch_ / "work", "scene"));
        write_whole_text(workspace.config_path(), kWorkspaceConfigHeader);
        SilentProgress progress;
        const Stage stage{{"pack", "code", parameters, "", "inputs"},
                          [&](const fs::path&) -> StageEvidence {
                              const bool is_foreign = fs::exists(product / "other.txt") &&
                                                      !fs::exists(product / "manifest.txt");
                              if (is_foreign) throw Error(ErrorKind::kBadInput, "E-TEST", "", "");
                              write_whole_text(product / "manifest.txt", parameters);
                              write_whole_text(product / "other.txt", parameters);
                              return {"{}", "{}"};
                          },
                          product};
        static_cast<void>(bring_up_to_date(workspace, stage, 1, progress));
    };
    pack("width = 1");
    fs::remove(product / "manifest.txt");
    pack("width = 2");
    EXPECT_EQ(read_whole_text(product / "manifest.txt"), "width = 2");
}

TEST_F(StageCache, TwoRunsDoNotShareAWorkspace) {
    const WorkspaceLayout layout(scratch_ / "work", "scene");
    const Workspace first(layout);
    try {
        const Workspace second(layout);
        FAIL() << "the workspace was taken twice";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-WORKSPACE-BUSY");
    }
}

TEST_F(StageCache, AFreedWorkspaceCanBeTakenAgain) {
    const WorkspaceLayout layout(scratch_ / "work", "scene");
    { const Workspace first(layout); }
    EXPECT_NO_THROW(Workspace{layout});
}

TEST(StageKey, EveryPartOfTheIdentityCounts) {
    const StageIdentity identity{"mesh", "code", "parameters", "tool", "inputs"};
    const std::string key = stage_key(identity);
    EXPECT_EQ(stage_key(identity), key);
    for (std::string StageIdentity::*part :
         {&StageIdentity::stage, &StageIdentity::code, &StageIdentity::parameters,
          &StageIdentity::external_tool, &StageIdentity::inputs}) {
        StageIdentity other = identity;
        other.*part += "x";
        EXPECT_NE(stage_key(other), key);
    }
    // Nor may text wander from one part to the next.
    EXPECT_NE(stage_key({"mesh", "code", "parameterst", "ool", "inputs"}), key);
}

TEST(Content, IsNamedRelativeToItsFolderAndSorted) {
    const ScratchFolder scratch;
    write_whole_text(scratch / "b.txt", "b");
    write_whole_text(scratch.path() / "a" / "z.txt", "z");
    write_whole_text(scratch / ".hidden", "no");
    const std::vector<ContentEntry> content = content_of(scratch.path(), 2);
    ASSERT_EQ(content.size(), 2U);
    EXPECT_EQ(content[0].name, "a/z.txt");
    EXPECT_EQ(content[1].name, "b.txt");
    EXPECT_EQ(content_of(scratch / "nothing", 1).size(), 0U);
}

}  // namespace
}  // namespace lumi
