#include "calib/poses/registration.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

ColmapPhotograph with_features(std::size_t count) {
    return {0, std::vector<Eigen::Vector2f>(count, Eigen::Vector2f::Zero())};
}

TEST(Registration, ExplainsEachPhotographThatWasNotPlaced) {
    std::vector<Photograph> photographs(5);
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        photographs[index].name = std::string(1, static_cast<char>('a' + index));
    }
    Capture capture;
    capture.views = {{"a", 0, {}}, {"c", 0, {}}};
    const std::vector<ColmapPhotograph> features{with_features(900), with_features(12),
                                                 with_features(900), with_features(900),
                                                 with_features(900)};
    // b is blank, d is tied to a and c by few matches, and e only to d, which was not placed.
    const std::vector<VerifiedPair> pairs{
        {0, 2, PairConfiguration::kCalibrated, std::vector<FeatureMatch>(300)},
        {0, 3, PairConfiguration::kCalibrated, std::vector<FeatureMatch>(16)},
        {2, 3, PairConfiguration::kCalibrated, std::vector<FeatureMatch>(21)},
        {3, 4, PairConfiguration::kCalibrated, std::vector<FeatureMatch>(80)}};
    const auto left_out = explain_unregistered(capture, photographs, features, pairs);
    ASSERT_EQ(left_out.size(), 3u);
    EXPECT_EQ(left_out[0].name, "b");
    EXPECT_EQ(left_out[0].code, "E-POSES-NOFEATURES");
    EXPECT_EQ(left_out[1].name, "d");
    EXPECT_EQ(left_out[1].code, "E-POSES-WEAK");
    EXPECT_THAT(left_out[1].reason, testing::HasSubstr("21 matches, with c"));
    EXPECT_EQ(left_out[2].name, "e");
    EXPECT_EQ(left_out[2].code, "E-POSES-NOMATCH");
}

TEST(Registration, DoesNotCallManyMatchesFew) {
    std::vector<Photograph> photographs(4);
    for (std::size_t index = 0; index < photographs.size(); ++index) {
        photographs[index].name = std::string(1, static_cast<char>('a' + index));
    }
    Capture capture;
    capture.views = {{"a", 0, {}}, {"b", 0, {}}};
    const std::vector<ColmapPhotograph> features(4, with_features(900));
    // c is tied to both that were placed, d to one of them.
    const std::vector<VerifiedPair> pairs{
        {0, 2, PairConfiguration::kCalibrated, std::vector<FeatureMatch>(60)},
        {1, 2, PairConfiguration::kCalibrated, std::vector<FeatureMatch>(540)},
        {1, 3, PairConfiguration::kCalibrated, std::vector<FeatureMatch>(128)}};
    const auto left_out = explain_unregistered(capture, photographs, features, pairs);
    ASSERT_EQ(left_out.size(), 2u);
    EXPECT_EQ(left_out[0].code, "E-POSES-WEAK");
    EXPECT_THAT(left_out[0].reason, testing::StartsWith("has 540 matches with b, but fits no"));
    EXPECT_EQ(left_out[1].code, "E-POSES-WEAK");
    EXPECT_THAT(left_out[1].reason,
                testing::StartsWith("shows what only one of the placed photographs shows (b, 128"));
}

TEST(Registration, DropsViewsThatSeeTooLittleAndKeepsTheRestConsistent) {
    Capture capture = synthetic_capture(pinhole_camera(1000, 800, 900), {});
    // View 2 keeps five points.
    for (std::size_t index = 5; index < capture.points.size(); ++index) {
        std::erase_if(capture.points[index].track,
                      [](const Observation& seen) { return seen.view_index == 2; });
    }
    const std::string after = capture.views[3].name;
    const Observation seen = capture.points[9].track.back();
    const std::string seen_from = capture.views[static_cast<std::size_t>(seen.view_index)].name;
    drop_weak_views(capture, 12);
    ASSERT_EQ(capture.views.size(), 7u);
    EXPECT_EQ(capture.views[2].name, after);
    const Observation now = capture.points[9].track.back();
    EXPECT_EQ(capture.views[static_cast<std::size_t>(now.view_index)].name, seen_from);
    EXPECT_EQ(now.pixel, seen.pixel);
    EXPECT_NO_THROW(validate(capture, "after dropping"));
}

}  // namespace
}  // namespace lumi
