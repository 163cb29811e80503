// A few of the captures of `lumi bench-hazards`, from harmless to hopeless: ctest label "slow".
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "pipeline/hazards/hazard_report.h"
#include "pipeline/hazards/trial.h"
#include "tests/calib/scratch_folder.h"

namespace lumi {
namespace {

struct Place {
    Hazard hazard;
    std::size_t step;
    std::uint64_t seed = 11;
};

std::string name_of_place(const testing::TestParamInfo<Place>& info) {
    std::string name = curve_of(info.param.hazard).name + std::to_string(info.param.step) + "seed" +
                       std::to_string(info.param.seed);
    std::erase(name, '-');
    return name;
}

Trial try_at(const Place& place) {
    const ScratchFolder folder;
    SilentProgress progress;
    TrialOptions options;
    options.with_colmap = false;
    return run_trial(place.hazard, curve_of(place.hazard).strengths[place.step], place.seed,
                     options, folder / "trial", progress);
}

class UsableCapture : public testing::TestWithParam<Place> {};

TEST_P(UsableCapture, IsPlacedRight) {
    const Trial trial = try_at(GetParam());
    EXPECT_EQ(trial.lumi.ending, Ending::kRight)
        << trial.lumi.code << " " << trial.lumi.what << " " << trial.lumi.error.position_share;
    if (GetParam().step == 0) {
        EXPECT_FALSE(trial.given_reason.has_value()) << "a complaint of what is harmless";
    }
}

INSTANTIATE_TEST_SUITE_P(Stress, UsableCapture,
                         testing::Values(Place{Hazard::kBlur, 0}, Place{Hazard::kForward, 0},
                                         Place{Hazard::kZoom, 2}, Place{Hazard::kOverlap, 0},
                                         Place{Hazard::kFisheye, 3},
                                         // Two groups that share a strip once passed as zoomed,
                                         // and once with one of them tilted.
                                         Place{Hazard::kOverlap, 1, 1},
                                         Place{Hazard::kOverlap, 1, 210},
                                         // Features of overexposed pictures, displaced together,
                                         // once passed for a zoom.
                                         Place{Hazard::kExposure, 2, 31}),
                         name_of_place);

class HopelessCapture : public testing::TestWithParam<Place> {};

TEST_P(HopelessCapture, IsRefusedForTheTrueReason) {
    const Trial trial = try_at(GetParam());
    EXPECT_EQ(trial.lumi.ending, Ending::kRefused) << trial.lumi.error.position_share;
    EXPECT_TRUE(reason_is_right(trial))
        << trial.lumi.code << " " << trial.lumi.what
        << ", doctor: " << (trial.doctor_reason ? code_of(*trial.doctor_reason) : "nothing");
}

INSTANTIATE_TEST_SUITE_P(Stress, HopelessCapture,
                         testing::Values(Place{Hazard::kRotation, 4}, Place{Hazard::kTexture, 3},
                                         Place{Hazard::kNoise, 4}, Place{Hazard::kShutter, 3},
                                         Place{Hazard::kRepetition, 4},
                                         Place{Hazard::kDuplicates, 4}),
                         name_of_place);

TEST(StressSummary, SaysWhatWasNotTried) {
    Trial trial{Hazard::kBlur, 0.0, 1, 8, {}, {}, {}, 0, {}};
    trial.lumi.ending = Ending::kRight;
    EXPECT_THAT(hazards_text({trial}), testing::HasSubstr("COLMAP alone: not tried"));
    EXPECT_EQ(summary_of({trial}).colmap.failed, 0);
    EXPECT_TRUE(hazards_json({trial}).at("rows").at(0).at("colmap").is_null());
}

TEST(StressSummary, CountsEndingsAndReasons) {
    Trial right{Hazard::kBlur, 0.0, 1, 8, {}, {}, {}, 0, {}};
    right.lumi.ending = Ending::kRight;
    right.colmap.ending = Ending::kFalse;
    Trial refused{Hazard::kBlur, 12, 1, 8, {}, {}, {}, 0, CaptureReason::kBlur};
    refused.lumi.ending = Ending::kRefused;
    refused.colmap.ending = Ending::kRefused;
    Trial misnamed = refused;
    misnamed.given_reason = CaptureReason::kNoise;
    const StressSummary summary = summary_of({right, refused, misnamed});
    EXPECT_EQ(summary.lumi.right, 1);
    EXPECT_EQ(summary.lumi.refused, 2);
    EXPECT_EQ(summary.colmap.false_successes, 1);
    EXPECT_EQ(summary.harmless, 1);
    EXPECT_EQ(summary.harmless_refused, 0);
    EXPECT_EQ(summary.reasons_right, 2);
    EXPECT_EQ(summary.troubled, 2);
    EXPECT_EQ(summary.troubled_reasons_right, 1);
}

}  // namespace
}  // namespace lumi
