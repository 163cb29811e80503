#include "calib/poses/mapping_ladder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "calib/capture/colmap_model.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "tests/calib/adjust/synthetic_capture.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Ten photographs, a program that plays COLMAP's mapper, and the models that it shall "find".
class Mapping : public testing::Test {
 protected:
    Mapping() {
        for (int index = 0; index < 10; ++index) {
            Photograph photograph;
            photograph.name = "walk/phöto " + std::to_string(index) + ".jpg";
            photographs_.push_back(photograph);
        }
        // Its n-th run leaves the models of models/n, whatever it is asked.
        const fs::path program = folder_.put_text(
            "colmap",
            "#!/bin/sh\n"
            "here=$(dirname \"$0\")\n"
            "while [ $# -gt 0 ]; do\n"
            "  [ \"$1\" = --output_path ] && out=$2\n"
            "  shift\n"
            "done\n"
            "echo run >> \"$here/runs\"\n"
            "run=$(wc -l < \"$here/runs\")\n"
            "[ -d \"$here/models/$run\" ] && cp -r \"$here/models/$run/.\" \"$out\"\n"
            ". \"$here/ending\"\n");
        fs::permissions(program, fs::perms::owner_all);
        folder_.put_text("ending", "exit 0\n");
        options_.colmap = program.string();
        groups_.camera_of_photograph.assign(10, 0);
        fs::create_directories(folder_ / "scratch");
        matched_.database = folder_ / "scratch/matched.db";  // As if it had been filled.
    }

    /// Lets the `run`-th run find a model of `views` photographs from `first` on.
    void plan_model(int run, int number, int views, int first = 0) {
        SyntheticCaptureOptions scene;
        scene.views = views;
        scene.points = 50;
        Capture capture = synthetic_capture(pinhole_camera(1000, 800, 900), scene);
        for (int index = 0; index < views; ++index) {
            capture.views[static_cast<std::size_t>(index)].name = colmap_image_name(first + index);
        }
        write_colmap_model_binary(
            capture, folder_ / ("models/" + std::to_string(run) + "/" + std::to_string(number)));
    }
    std::optional<Capture> map() {
        const MappingJob job{photographs_,        groups_, options_,  false,    true,
                             folder_ / "scratch", 1,       progress_, evidence_};
        return map_by_ladder(job, matched_);
    }
    long runs() const {
        const std::string text = read_whole_text(folder_ / "runs");
        return std::count(text.begin(), text.end(), '\n');
    }

    ScratchFolder folder_;
    std::vector<Photograph> photographs_;
    CameraGroups groups_;
    PoseOptions options_;
    MatchedPhotographs matched_;
    PoseEvidence evidence_;
    SilentProgress progress_;
};

TEST_F(Mapping, StopsAtTheFirstRungThatPlacesAll) {
    plan_model(1, 0, 10);
    const auto capture = map();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->views.size(), 10u);
    EXPECT_EQ(runs(), 1);
    EXPECT_EQ(evidence_.start, "COLMAP's own start");
    ASSERT_EQ(evidence_.calls.size(), 1u);
    EXPECT_THAT(evidence_.calls[0].command_line, testing::HasSubstr("--Mapper.init_min_tri_angle"));
}

TEST_F(Mapping, ClimbsDownToAGentlerStartAndKeepsTheBetterModel) {
    plan_model(1, 0, 4);
    plan_model(2, 0, 9);
    EXPECT_EQ(map()->views.size(), 9u);
    EXPECT_EQ(runs(), 2);
    EXPECT_THAT(evidence_.start, testing::HasSubstr("gentler start"));
}

TEST_F(Mapping, KeepsTheStricterModelWhenAGentlerOneIsNoBetter) {
    plan_model(1, 0, 8);
    plan_model(2, 0, 6);
    EXPECT_EQ(map()->views.size(), 8u);
    EXPECT_EQ(evidence_.start, "COLMAP's own start");
}

/// The last rung looks for more features, and there are no pictures here to look in.
TEST_F(Mapping, AModelIsKeptWhereMoreFeaturesCannotBeFound) {
    plan_model(1, 0, 4);
    const auto capture = map();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->views.size(), 4u);
    EXPECT_EQ(runs(), 3);
}

TEST_F(Mapping, WithoutAModelWhatKeepsMoreFeaturesFromBeingFoundIsSaid) {
    EXPECT_THROW(static_cast<void>(map()), Error);
}

TEST_F(Mapping, ChoosesTheModelWithMostPhotographsNotTheFirst) {
    plan_model(1, 0, 2);
    plan_model(1, 1, 9, 1);
    const auto capture = map();
    EXPECT_EQ(capture->views.size(), 9u);
    EXPECT_EQ(evidence_.models_found, 2);
}

TEST_F(Mapping, GivesPhotographsTheirOwnNamesBack) {
    plan_model(1, 0, 9, 1);
    const auto capture = map();
    EXPECT_EQ(capture->views.front().name, "walk/phöto 1.jpg");
    EXPECT_EQ(capture->views.back().name, "walk/phöto 9.jpg");
}

TEST_F(Mapping, TheExitStatusIsNoEvidence) {
    plan_model(2, 0, 10);  // The first run says 0 and leaves nothing; both runs say 1 here.
    folder_.put_text("ending", "exit 1\n");
    EXPECT_EQ(map()->views.size(), 10u);
    EXPECT_EQ(runs(), 2);
}

TEST_F(Mapping, AModelThatAKilledRunHadFinishedIsKept) {
    plan_model(1, 0, 10);
    folder_.put_text("ending", "kill -SEGV $$\n");
    EXPECT_EQ(map()->views.size(), 10u);
}

TEST_F(Mapping, RefusesATruncatedModelThatWasCalledASuccess) {
    plan_model(1, 0, 10);
    const fs::path points = folder_ / "models/1/0/points3D.bin";
    fs::resize_file(points, fs::file_size(points) / 2);
    try {
        static_cast<void>(map());
        ADD_FAILURE() << "expected an error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-COLMAP-MODEL");
    }
}

TEST_F(Mapping, RefusesAModelOfPhotographsThatWereNotGiven) {
    plan_model(1, 0, 5, 8);
    EXPECT_THROW(static_cast<void>(map()), Error);
}

TEST_F(Mapping, DropsLensesWithoutAPhotograph) {
    Capture capture = synthetic_capture(pinhole_camera(1000, 800, 900), {});
    capture.cameras.insert(capture.cameras.begin(), pinhole_camera(10, 10, 10));
    for (std::size_t index = 0; index < capture.views.size(); ++index) {
        capture.views[index].name = colmap_image_name(static_cast<int>(index));
        capture.views[index].camera_index = 1;
    }
    write_colmap_model_binary(capture, folder_ / "found/0");
    const auto best = read_best_model(folder_ / "found", photographs_);
    ASSERT_TRUE(best.has_value());
    ASSERT_EQ(best->capture.cameras.size(), 1u);
    EXPECT_EQ(best->capture.cameras[0].width_px, 1000);
    EXPECT_EQ(best->capture.views[0].camera_index, 0);
}

TEST_F(Mapping, HasNoModelWhereThereIsNone) {
    EXPECT_FALSE(read_best_model(folder_ / "nothing", photographs_).has_value());
}

}  // namespace
}  // namespace lumi
