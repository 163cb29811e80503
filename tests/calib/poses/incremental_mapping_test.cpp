#include "calib/poses/incremental_mapping.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/calib/poses/matched_job.h"

namespace lumi {
namespace {

/// Ten photographs along an arc, and what is known of them after matching.
class IncrementalMapping : public MatchedJob {
 protected:
    IncrementalMapping() {
        SyntheticCaptureOptions options;
        options.views = 10;
        options.points = 400;
        options.arc_deg = 90;
        match(synthetic_capture(pinhole_camera(1000, 800, 900), options));
    }

    /// Photographs below `from` and the others have no pair in common.
    void cut(int from) {
        std::erase_if(matched_.pairs, [&](const VerifiedPair& pair) {
            return pair.first < from && pair.second >= from;
        });
    }
    /// Gives each scene point a look of its own, in all photographs.
    void add_features() {
        std::mt19937 random(6);
        for (const ColmapPhotograph& photograph : scene_.photographs) {
            Features features;
            for (const Eigen::Vector2f& pixel : photograph.keypoints_px) {
                features.keypoints.push_back({pixel, 1});
            }
            matched_.features.push_back(std::move(features));
        }
        for (const ScenePoint& point : scene_.truth.points) {
            Descriptor look{};
            for (int count = 0; count < 8; ++count) look[random() % kDescriptorSize] = 180;
            for (const Observation& seen : point.track) {
                matched_.features[static_cast<std::size_t>(seen.view_index)].descriptors.push_back(
                    look);
            }
        }
    }
    std::optional<Capture> map() { return map_incrementally(job(), matched_); }
};

TEST_F(IncrementalMapping, PlacesAllOfAConnectedCapture) {
    const auto capture = map();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->views.size(), 10u);
    EXPECT_LT(relative_position_error(*capture, scene_.truth), 1e-4);
    EXPECT_EQ(evidence_.models_found, 1);
    EXPECT_THAT(evidence_.warnings, testing::IsEmpty());
}

TEST_F(IncrementalMapping, TellsOfAPartThatNothingConnects) {
    cut(4);
    const auto capture = map();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->views.size(), 6u);
    EXPECT_EQ(evidence_.models_found, 2);
    ASSERT_EQ(evidence_.warnings.size(), 1u);
    EXPECT_THAT(evidence_.warnings[0], testing::HasSubstr("another 4"));
}

TEST_F(IncrementalMapping, BridgesPartsThatTheirFeaturesConnect) {
    cut(4);
    add_features();
    const auto capture = map();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->views.size(), 10u);
    EXPECT_LT(relative_position_error(*capture, scene_.truth), 1e-4);
    EXPECT_THAT(evidence_.start, testing::HasSubstr("lenient matches"));
    EXPECT_EQ(evidence_.models_found, 1);
}

/// There are no pictures to look for more features in.
TEST_F(IncrementalMapping, KeepsItsModelWhereMoreFeaturesCannotBeFound) {
    cut(4);
    add_features();
    for (Features& features : matched_.features) {
        for (Descriptor& look : features.descriptors) look.fill(0);  // Nothing bridges the parts.
    }
    const auto capture = map();
    ASSERT_TRUE(capture.has_value());
    EXPECT_EQ(capture->views.size(), 6u);
    EXPECT_EQ(evidence_.start.find("more features"), std::string::npos);
}

TEST_F(IncrementalMapping, HasNoModelWithoutAPair) {
    matched_.pairs.clear();
    EXPECT_FALSE(map().has_value());
}

}  // namespace
}  // namespace lumi
