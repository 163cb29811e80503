#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "calib/work/whole_file.h"
#include "pipeline/pose_bench/pose_chart.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

using testing::HasSubstr;

PoseTrial trial(const PoseMeans& means, double cpu_s, int placed, double median_m) {
    PoseTrial result;
    result.means = means;
    result.cost.cpu_s = cpu_s;
    result.photographs = 11;
    result.placed = placed;
    if (median_m > 0) {
        result.difference.emplace();
        result.difference->median_position = median_m;
    }
    return result;
}

TEST(PoseBench, TableHasALineForEachTrial) {
    PoseTrial refused =
        trial({PoseProgram::kLumi, PoseProgram::kColmap, false, 1024, 800}, 2, 0, 0);
    refused.refusal = "E-POSES-NOPAIR";
    PoseTrial placed = trial({}, 7.5, 11, 0.0025);
    placed.lens = "RADIAL";
    placed.focal_px = 500;
    const std::string csv = trials_csv({placed, refused});
    EXPECT_THAT(
        csv,
        HasSubstr("\nlumi,lumi,0,4096,1600,auto,7.500,0.000,11,11,0,\"RADIAL\",500.00,0.002500,"));
    EXPECT_THAT(
        csv, HasSubstr(
                 "\nlumi,colmap,0,1024,800,auto,2.000,0.000,11,0,0,\"\",0.00,,,,E-POSES-NOPAIR\n"));
}

TEST(PoseBench, ChartShowsWhatWasTried) {
    const ScratchFolder scratch;
    SilentProgress progress;
    const std::vector<PoseTrial> trials{
        trial({PoseProgram::kLumi, PoseProgram::kLumi, false, 2048, 1600}, 5, 11, 0.003),
        trial({PoseProgram::kLumi, PoseProgram::kLumi, false, 8192, 1600}, 12, 11, 0.0024),
        trial({PoseProgram::kLumi, PoseProgram::kLumi, false, 4096, 1600, "RADIAL"}, 8, 11, 0.003),
        trial({PoseProgram::kColmap, PoseProgram::kColmap, true, 8192, 1600}, 90, 10, 0.0026)};
    draw_pose_chart(trials, "the title", scratch / "poses.svg", progress);
    const std::string svg = read_whole_text(scratch / "poses.svg");
    EXPECT_THAT(svg, HasSubstr("<svg"));
    EXPECT_THAT(svg, HasSubstr("the title"));
    EXPECT_THAT(svg, HasSubstr("median position error, mm"));
    EXPECT_THAT(svg, HasSubstr(">8192<"));
    EXPECT_THAT(svg, HasSubstr("8192, 10 placed"));
    EXPECT_THAT(svg, HasSubstr(">RADIAL<"));
    EXPECT_THAT(svg, HasSubstr("lens models, 4096 features"));
}

TEST(PoseBench, ChartWithoutTruthShowsWhatWasNotPlaced) {
    const ScratchFolder scratch;
    SilentProgress progress;
    draw_pose_chart({trial({}, 5, 9, 0)}, "no truth", scratch / "poses.svg", progress);
    EXPECT_THAT(read_whole_text(scratch / "poses.svg"), HasSubstr("photographs not placed, %"));
}

TEST(PoseBench, MatchingIsTimedForEveryInstructionSetHere) {
    SilentProgress progress;
    const auto costs = time_matching(64, progress);
    ASSERT_FALSE(costs.empty());
    EXPECT_EQ(costs.front().instructions, "portable");
    for (const MatchingCost& cost : costs) EXPECT_GE(cost.cpu_s, 0);
}

TEST(PoseBench, TimingOfMatchingCanBeInterrupted) {
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW(static_cast<void>(time_matching(64, progress)), Error);
}

TEST(PoseBench, TrialsLeaveNothingAndTouchNothingInTheScratchFolder) {
    const ScratchFolder scratch;
    write_png(scratch / "photos" / "1.png", ColorImage(128, 96, {90, 120, 30}));
    write_png(scratch / "photos" / "2.png", ColorImage(128, 96, {30, 90, 120}));
    PoseTrialSetting setting;
    setting.photographs = scratch / "photos";
    setting.scratch_folder = scratch / "user";
    setting.threads = 1;
    write_whole_text(setting.scratch_folder / "poses" / "notes.txt", "the user's own");
    write_whole_text(setting.scratch_folder / "copies" / "1.png", "the user's own");
    SilentProgress progress;
    EXPECT_NE(try_poses(setting, {}, progress).refusal, "");
    EXPECT_EQ(read_whole_text(setting.scratch_folder / "poses" / "notes.txt"), "the user's own");
    EXPECT_EQ(read_whole_text(setting.scratch_folder / "copies" / "1.png"), "the user's own");
    EXPECT_EQ(
        std::distance(std::filesystem::directory_iterator(setting.scratch_folder / "copies"), {}),
        1);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(setting.scratch_folder), {}), 2);
}

}  // namespace
}  // namespace lumi
