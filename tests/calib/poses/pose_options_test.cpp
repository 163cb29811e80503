#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "calib/poses/pose_stage.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

TEST(PoseOptions, DefaultsAreValid) {
    EXPECT_NO_THROW(validate(PoseOptions{}));
    const PoseOptions read = read_pose_options(ConfigSection::from_text("", "empty"));
    EXPECT_EQ(read.lens_model, PoseOptions{}.lens_model);
    EXPECT_EQ(read.max_features, PoseOptions{}.max_features);
}

TEST(PoseStage, SaysHowManyPhotographsItWasGivenWhereTheyAreTooFew) {
    SilentProgress progress;
    const auto refusal_of = [&](std::size_t photographs) -> std::string {
        try {
            static_cast<void>(estimate_poses(std::vector<Photograph>(photographs), std::nullopt, {},
                                             "not made", 1, progress));
        } catch (const Error& error) {
            return error.code() + ": " + error.what();
        }
        return {};
    };
    EXPECT_EQ(refusal_of(0), "E-POSES-FEW: there are no photographs: at least two are needed");
    EXPECT_EQ(refusal_of(1), "E-POSES-FEW: one photograph is not enough: at least two are needed");
}

TEST(PoseOptions, ReadsEveryKey) {
    const ConfigSection section = ConfigSection::from_text(R"(
lens_model = "OPENCV"
shared_lens = false
refine_lens = false
max_features = 1000
max_reprojection_error_px = 1.5
min_track_length = 3
min_registered_share = 0.75
time_limit_s = 60.5
front_end = "colmap"
mapper = "colmap"
colmap = "/opt/colmap"
masks = "/turntable/masks"
)",
                                                           "test");
    const PoseOptions options = read_pose_options(section);
    EXPECT_NO_THROW(section.expect_all_keys_known());
    EXPECT_EQ(options.lens_model, "OPENCV");
    EXPECT_FALSE(options.shared_lens);
    EXPECT_FALSE(options.refine_lens);
    EXPECT_EQ(options.max_features, 1000);
    EXPECT_EQ(options.max_reprojection_error_px, 1.5);
    EXPECT_EQ(options.min_track_length, 3);
    EXPECT_EQ(options.min_registered_share, 0.75);
    EXPECT_EQ(options.time_limit_s, 60.5);
    EXPECT_EQ(options.front_end, PoseProgram::kColmap);
    EXPECT_EQ(options.mapper, PoseProgram::kColmap);
    EXPECT_EQ(options.colmap, "/opt/colmap");
    EXPECT_EQ(options.mask_folder, "/turntable/masks");
}

TEST(PoseOptions, RefusesProgramsThatItDoesNotKnow) {
    for (const char* const key : {"front_end", "mapper"}) {
        const auto read = [&](const std::string& name) {
            return read_pose_options(
                ConfigSection::from_text(key + (" = \"" + name + "\""), "programs"));
        };
        EXPECT_NO_THROW(static_cast<void>(read("lumi")));
        EXPECT_NO_THROW(static_cast<void>(read("colmap")));
        EXPECT_THROW(static_cast<void>(read("hand")), Error) << key;
    }
}

TEST(PoseOptions, RefusesEachValueOutOfRange) {
    const std::vector<std::function<void(PoseOptions&)>> mistakes{
        [](PoseOptions& options) { options.lens_model = "PERFECT"; },
        [](PoseOptions& options) { options.max_features = 0; },
        [](PoseOptions& options) { options.max_reprojection_error_px = 0; },
        [](PoseOptions& options) { options.min_track_length = 1; },
        [](PoseOptions& options) { options.min_registered_share = 0; },
        [](PoseOptions& options) { options.min_registered_share = 1.01; },
        [](PoseOptions& options) { options.time_limit_s = 0; },
        [](PoseOptions& options) { options.colmap.clear(); }};
    for (std::size_t index = 0; index < mistakes.size(); ++index) {
        PoseOptions options;
        mistakes[index](options);
        EXPECT_THROW(validate(options), Error) << "mistake " << index;
    }
}

}  // namespace
}  // namespace lumi
