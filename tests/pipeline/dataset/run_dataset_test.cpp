#include "pipeline/dataset/run_dataset.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <new>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/workspace/done_marker.h"
#include "pipeline/workspace/stage_outputs.h"
#include "pipeline/workspace/workspace.h"
#include "tests/calib/noted_progress.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::EndsWith;
using testing::IsEmpty;
using testing::Not;

/// Does something when the first stage of the first scene begins.
class TroubleAtTheStart final : public Progress {
 public:
    explicit TroubleAtTheStart(std::function<void()> trouble) : trouble_(std::move(trouble)) {}
    void begin(const std::string&, std::size_t) override {}
    void advance(std::size_t) override {}
    void note(const std::string& message) override {
        if (message.starts_with("ingest: runs") && std::exchange(is_first_, false)) trouble_();
    }

 private:
    std::function<void()> trouble_;
    bool is_first_ = true;
};

/// Empty of a scene that was built.
std::string code_of(const SceneOutcome& outcome) {
    return outcome.failure ? outcome.failure->code() : "";
}

/// Two scenes without a photograph: that which is begun ends with an error of its photographs.
class DatasetRun : public testing::Test {
 protected:
    DatasetRun() {
        write_whole_text(scratch_.path() / "photos" / "readme.txt", "no photograph");
        write_whole_text(scratch_ / "c.toml", "name = \"c\"\n[capture]\nphotos = \"photos\"\n");
        write_whole_text(scratch_ / "set.toml",
                         "[[scene]]\nconfig = \"c.toml\"\nname = \"statue\"\n"
                         "[[scene]]\nphotos = \"photos\"\n");
    }
    [[nodiscard]] fs::path folder() const { return scratch_ / "work"; }
    [[nodiscard]] std::vector<SceneOutcome> run(Progress& progress) const {
        return run_dataset(read_dataset(scratch_ / "set.toml"), folder(), 1, progress);
    }
    /// What becomes of the scenes when the first throws that.
    template <class Exception>
    [[nodiscard]] std::vector<std::string> failures_after(const Exception& exception) const {
        TroubleAtTheStart progress([&] { throw exception; });
        std::vector<std::string> codes;
        for (const SceneOutcome& outcome : run(progress)) codes.push_back(code_of(outcome));
        return codes;
    }

    ScratchFolder scratch_;
};

using Codes = std::vector<std::string>;

TEST_F(DatasetRun, AWorkspaceIsFoundAgainByTheNameOfItsScene) {
    SilentProgress progress;
    static_cast<void>(run(progress));
    const WorkspaceLayout statue = find_workspace(folder() / "statue");
    EXPECT_EQ(statue.name(), "statue");
    EXPECT_EQ(statue.package_folder(), folder() / "statue" / "statue.lumi");
}

TEST_F(DatasetRun, AWorkspaceThatAnotherRunHoldsDoesNotEndTheOthers) {
    fs::create_directories(folder() / "statue");
    const FolderLock other_run(folder() / "statue");
    SilentProgress progress;
    const std::vector<SceneOutcome> outcomes = run(progress);
    ASSERT_EQ(outcomes.size(), 2U);
    EXPECT_EQ(code_of(outcomes[0]), "E-WORKSPACE-BUSY");
    EXPECT_TRUE(code_of(outcomes[1]).starts_with("E-INGEST")) << code_of(outcomes[1]);
}

TEST_F(DatasetRun, ASceneDoesNotTakeThePlaceOfAnotherCapture) {
    const fs::path taken = folder() / "statue";
    fs::create_directories(scratch_ / "others");
    const std::string configuration = std::string(kWorkspaceConfigHeader) +
                                      "\nname = \"statue\"\n[capture]\nphotos = \"" +
                                      (scratch_ / "others").string() + "\"\n";
    write_whole_text(taken / "config.toml", configuration);
    write_done_marker(taken / "ingest" / kDoneMarkerName, {{"ingest", "", "", "", ""}, {}, {}, {}});
    SilentProgress progress;
    const std::vector<SceneOutcome> outcomes = run(progress);
    ASSERT_EQ(outcomes.size(), 2U);
    EXPECT_EQ(code_of(outcomes[0]), "E-WORKSPACE-OTHER");
    EXPECT_TRUE(code_of(outcomes[1]).starts_with("E-INGEST")) << code_of(outcomes[1]);
    EXPECT_EQ(read_whole_text(taken / "config.toml"), configuration);
}

TEST_F(DatasetRun, AFolderThatCannotBeMadeIsSaidToBeUnwritable) {
    write_whole_text(scratch_ / "work", "a file");
    SilentProgress progress;
    try {
        static_cast<void>(run(progress));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-FILE-WRITE");
    }
}

TEST_F(DatasetRun, TwoRunsDoNotBuildOneDataset) {
    fs::create_directories(folder());
    const FolderLock other_run(folder());
    SilentProgress progress;
    try {
        static_cast<void>(run(progress));
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-WORKSPACE-BUSY");
    }
    EXPECT_FALSE(fs::exists(folder() / "statue"));
}

TEST_F(DatasetRun, TheReportOfASceneThatFailsTellsOfTheFailure) {
    SilentProgress progress;
    for (const SceneOutcome& outcome : run(progress))
        EXPECT_THAT(read_whole_text(folder() / outcome.name / "report.html"),
                    testing::HasSubstr(code_of(outcome)));
}

TEST_F(DatasetRun, TheReportTellsOfWhatIsNamedAndMissing) {
    write_whole_text(scratch_ / "c.toml",
                     "name = \"c\"\n[capture]\nphotos = \"photos\"\n[poses]\nmasks = \"gone\"\n");
    SilentProgress progress;
    EXPECT_EQ(code_of(run(progress).at(0)), "E-CONFIG-PATH");
    EXPECT_THAT(read_whole_text(folder() / "statue" / "report.html"),
                testing::HasSubstr("E-CONFIG-PATH"));
}

TEST_F(DatasetRun, WhatToDoAboutAFailureIsToldWithIt) {
    NotedProgress progress;
    for (const SceneOutcome& outcome : run(progress)) {
        ASSERT_TRUE(outcome.failure);
        EXPECT_THAT(outcome.failure->advice(), Not(IsEmpty()));
        EXPECT_THAT(progress.notes, Contains(EndsWith(" -> " + outcome.failure->advice())));
    }
}

TEST_F(DatasetRun, AFileSystemsOrAMemorysErrorIsThatOfItsScene) {
    const std::string of_the_other = failures_after(std::bad_alloc()).at(1);
    EXPECT_TRUE(of_the_other.starts_with("E-INGEST")) << of_the_other;
    EXPECT_EQ(failures_after(std::bad_alloc()), (Codes{"E-MEMORY", of_the_other}));
    const fs::filesystem_error looping(
        "loop", std::make_error_code(std::errc::too_many_symbolic_link_levels));
    EXPECT_EQ(failures_after(looping), (Codes{"E-FILE-SYSTEM", of_the_other}));
    const Error too_large(ErrorKind::kResources, "E-DEPTH-MEMORY", "too large", "");
    EXPECT_EQ(failures_after(too_large), (Codes{"E-DEPTH-MEMORY", of_the_other}));
}

TEST_F(DatasetRun, AFullDiskOrAnInterruptionEndsIt) {
    const fs::filesystem_error full("full", std::make_error_code(std::errc::no_space_on_device));
    EXPECT_THROW(static_cast<void>(failures_after(full)), Error);
    const Error stopped(ErrorKind::kInterrupted, "E-INTERRUPTED", "stopped", "");
    EXPECT_THROW(static_cast<void>(failures_after(stopped)), Error);
}

}  // namespace
}  // namespace lumi
