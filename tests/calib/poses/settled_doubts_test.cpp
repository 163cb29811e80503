// What becomes of a model once doubts are settled: taken, taken with a warning, or refused by name.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/pictures/image_io.h"
#include "calib/poses/model_doubts.h"
#include "calib/work/error.h"
#include "tests/calib/poses/matched_job.h"
#include "tests/calib/scratch_folder.h"
#include "tests/calib/test_pictures.h"

namespace lumi {
namespace {

class SettledDoubts : public MatchedJob {
 protected:
    SettledDoubts() {
        SyntheticCaptureOptions options;
        options.noise_px = 0.5;
        match(synthetic_capture(pinhole_camera(1000, 800, 900), options));
        // Who is refused is asked whether the pictures are poor: these are not.
        write_png(folder_ / "fine.png", wavy_picture(1000, 800));
        for (Photograph& photograph : photographs_) {
            photograph.picture_path = folder_ / "fine.png";
            photograph.width_px = 1000;
            photograph.height_px = 800;
        }
    }

    /// Of photographs so many steps apart, the first `matches` take each point for another one, and
    /// the others are not found.
    void mistake(int steps, std::size_t matches) {
        for (VerifiedPair& pair : matched_.pairs) {
            if (pair.second - pair.first != steps) continue;
            ASSERT_GT(pair.inliers.size(), matches);
            const std::vector<FeatureMatch> right = pair.inliers;
            pair.inliers.resize(matches);
            for (std::size_t i = 0; i < matches; ++i)
                pair.inliers[i].second = right[(i + right.size() / 2) % right.size()].second;
        }
    }

    void settle(const Capture& model) { settle_doubts(job(), matched_, model, model); }

    /// What it is refused with; empty where it is not.
    std::string refusal_of(const Capture& model) {
        try {
            settle(model);
        } catch (const Error& error) {
            return error.code() + ": " + error.what();
        }
        return {};
    }

    ScratchFolder folder_;
};

TEST_F(SettledDoubts, LeaveATrueModelWithoutAWord) {
    settle(scene_.truth);
    EXPECT_TRUE(evidence_.warnings.empty());
    EXPECT_EQ(evidence_.contradicted_share, 0.0);
}

TEST_F(SettledDoubts, WarnWhereWhatLooksAlikeIsOutweighed) {
    mistake(4, 32);
    settle(scene_.truth);
    ASSERT_EQ(evidence_.warnings.size(), 1u);
    EXPECT_THAT(evidence_.warnings.front(),
                testing::AllOf(testing::StartsWith("E-POSES-REPEATED"),
                               testing::HasSubstr("of 28 pairs of photographs 4 say otherwise")));
}

TEST_F(SettledDoubts, RefuseAModelThatPutsACameraElsewhereAndSayHowManyPairsDenyIt) {
    Capture wrong = scene_.truth;
    wrong.views[0].cam_from_world = wrong.views[5].cam_from_world;
    wrong.views[0].cam_from_world.translation.y() += 1.0;
    EXPECT_THAT(refusal_of(wrong),
                testing::AllOf(testing::StartsWith("E-POSES-REPEATED"),
                               testing::ContainsRegex("[5-7] of 28 pairs, and "),
                               testing::HasSubstr("were taken for one another")));
}

TEST_F(SettledDoubts, NameAsUncertainACameraThatIsOnlyTurnedALittle) {
    Capture bent = scene_.truth;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
    Rigid3& pose = bent.views[0].cam_from_world;
    pose = {turn * pose.rotation, turn * pose.translation};
    EXPECT_THAT(refusal_of(bent), testing::StartsWith("E-POSES-UNCERTAIN"));
}

}  // namespace
}  // namespace lumi
