#include "pipeline/line/line.h"

#include <gtest/gtest.h>

#include "calib/capture/colmap_model.h"
#include "calib/work/whole_file.h"
#include "tests/calib/scratch_folder.h"
#include "tests/pipeline/told_choices.h"
#include "tests/truth/textured_box_scene.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Whether and why each stage ran: "" for what was up to date.
using Reasons = std::vector<std::string>;

/// The textured box with its true poses, built again and again in one workspace.
class LineRun : public testing::Test {
 protected:
    LineRun() {
        SilentProgress progress;
        synthesize_into(scratch_.path(), textured_box_description(), 0, progress);
    }

    Reasons build(const std::string& before, const std::string& photos, const std::string& more) {
        write_whole_text(scratch_ / "box.toml", before + "[capture]\nphotos = \"" + photos +
                                                    "\"\nimport = \"truth/sparse\"\n" +
                                                    kSparseDepth + kToldDrawing + more);
        const BuildConfig config = load_build_config(scratch_ / "box.toml");
        const Workspace workspace(WorkspaceLayout(workspace_folder_, config.name));
        SilentProgress progress;
        Reasons reasons;
        for (const FinishedStage& stage : run_line(config, workspace, "pack", 0, progress)) {
            reasons.push_back(stage.reason);
        }
        return reasons;
    }

    ScratchFolder scratch_;
    fs::path workspace_folder_ = scratch_ / "photos" / "work" / "box";
};

const Reasons kAllUpToDate(5);

TEST_F(LineRun, WhatDecidesNothingIsNoReasonToRun) {
    const std::string few = "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n[package]\nmax_views = 3\n";
    EXPECT_EQ(build("", "photos", few), Reasons(5, "not done before"));
    EXPECT_EQ(build("", "photos", few), kAllUpToDate);
    EXPECT_EQ(build("threads = 1\n", "./photos/", few), kAllUpToDate);
    EXPECT_EQ(build("", "photos", few + "[poses]\nmax_features = 100\n"), kAllUpToDate);
    // The workspace lies among the photographs, and so do other things.
    write_whole_text(scratch_ / "photos" / "notes.txt", "a text");
    EXPECT_EQ(build("", "photos", few), kAllUpToDate);
}

TEST_F(LineRun, HowAPathIsSpeltIsNoReasonToRun) {
    const auto build_from = [&](const std::string& folder) {
        write_whole_text(scratch_ / "box.toml",
                         "[capture]\nphotos = \"photos\"\nimport = \"truth/sparse\"\n"
                         "[depth]\nimport_folder = \"" +
                             folder + "\"\n" + kToldDrawing);
        const BuildConfig config = load_build_config(scratch_ / "box.toml");
        const Workspace workspace(WorkspaceLayout(workspace_folder_, config.name));
        SilentProgress progress;
        Reasons reasons;
        for (const FinishedStage& stage : run_line(config, workspace, "pack", 0, progress))
            reasons.push_back(stage.reason);
        return reasons;
    };
    EXPECT_EQ(build_from("truth/depth"), Reasons(5, "not done before"));
    EXPECT_EQ(build_from("./truth/../truth/depth/"), kAllUpToDate);
    EXPECT_EQ(build_from((scratch_ / "truth" / "depth").string()), kAllUpToDate);
    // By what lies there the stage's result is decided.
    fs::rename(scratch_ / "truth" / "depth", scratch_ / "moved");
    EXPECT_EQ(build_from("moved"), kAllUpToDate);
    EXPECT_EQ(build("", "photos", "").at(3), "parameters changed");
}

TEST_F(LineRun, AStageTellsWhetherItsParametersOrItsInputsChanged) {
    const std::string few = "[package]\nmax_views = 3\n";
    static_cast<void>(build("", "photos", few));
    EXPECT_EQ(build("", "photos", "[package]\nmax_views = 4\n"),
              (Reasons{"", "", "", "", "parameters changed"}));
    const fs::path sparse = scratch_ / "truth" / "sparse";
    Capture capture = read_colmap_model(sparse);
    capture.views.front().cam_from_world.translation.x() += 1e-3;
    write_colmap_model_text(capture, sparse);
    EXPECT_EQ(
        build("", "photos", "[package]\nmax_views = 4\n"),
        (Reasons{"", "inputs changed", "inputs changed", "inputs changed", "inputs changed"}));
    EXPECT_EQ(build("", "photos",
                    "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n[package]\nmax_views = 4\n"),
              (Reasons{"", "", "inputs changed", "inputs changed", "inputs changed"}));
}

}  // namespace
}  // namespace lumi
