// Where sides of one thing are taken for one another, and the order of the photographs tells.
#include "calib/poses/order_of_taking.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <random>

#include "calib/poses/pair_agreement.h"
#include "tests/calib/poses/matched_job.h"

namespace lumi {
namespace {

constexpr int kSides = 4;
constexpr int kPhotographs = 36;
constexpr std::size_t kOfOneSide = kPhotographs / kSides;

/// Around +y, from one side to the next.
Eigen::Matrix3d turn_to_next_side() {
    return Eigen::AngleAxisd(2 * std::numbers::pi / kSides, Eigen::Vector3d::UnitY())
        .toRotationMatrix();
}

/// Thirty-six photographs around a thing whose four sides are alike, each of which shows what faces
/// it.
class FourSides : public MatchedJob {
 protected:
    FourSides() {
        SyntheticCaptureOptions options;
        options.views = kPhotographs;
        options.points = 120;
        options.arc_deg = 350;
        const Camera camera = pinhole_camera(1000, 800, 900);
        Capture truth = synthetic_capture(camera, options);
        std::mt19937 random(1);
        std::normal_distribution<double> of_a_hand(0.0, 0.05);
        for (View& view : truth.views)
            view.cam_from_world.translation +=
                Eigen::Vector3d(of_a_hand(random), of_a_hand(random), of_a_hand(random));
        std::vector<ScenePoint> of_one_side;
        of_one_side.swap(truth.points);
        Eigen::Matrix3d turn = Eigen::Matrix3d::Identity();
        for (int side = 0; side < kSides; ++side, turn = turn_to_next_side() * turn)
            for (const ScenePoint& point : of_one_side)
                truth.points.push_back(seen_from_its_side(truth, turn * point.position_in_world));
        match(std::move(truth));
    }

    static ScenePoint seen_from_its_side(const Capture& capture, const Eigen::Vector3d& position) {
        constexpr double kFacing = 0.3;
        ScenePoint point;
        point.position_in_world = position;
        for (std::size_t view = 0; view < capture.views.size(); ++view) {
            const Rigid3& pose = capture.views[view].cam_from_world;
            const Eigen::Vector3d towards = centre_in_world(pose).normalized();
            const auto pixel = project(capture.cameras[0], pose * position);
            if (pixel && is_inside(capture.cameras[0], *pixel) && position.dot(towards) > kFacing)
                point.track.push_back({static_cast<int>(view), *pixel});
        }
        return point;
    }

    /// Photographs a side apart, and those up to two from there, show what looks the same: they are
    /// matched as if they showed it.
    void mistake_sides() {
        const std::size_t of_one_side = scene_.truth.points.size() / kSides;
        std::vector<std::map<std::size_t, std::uint32_t>> feature_of(photographs_.size());
        std::vector<std::uint32_t> features(photographs_.size(), 0);
        for (std::size_t point = 0; point < scene_.truth.points.size(); ++point)
            for (const Observation& seen : scene_.truth.points[point].track) {
                const auto view = static_cast<std::size_t>(seen.view_index);
                feature_of[view][point] = features[view]++;
            }
        for (std::size_t first = 0; first < photographs_.size(); ++first)
            for (std::size_t second = first + kOfOneSide - 2; second < photographs_.size();
                 ++second) {
                const std::size_t sides = (second - first + 2) / kOfOneSide;
                if (second - first + 2 - kOfOneSide * sides > 4) continue;
                std::erase_if(matched_.pairs, [&](const VerifiedPair& pair) {
                    return pair.first == static_cast<int>(first) &&
                           pair.second == static_cast<int>(second);
                });
                VerifiedPair mistaken{static_cast<int>(first),
                                      static_cast<int>(second),
                                      PairConfiguration::kUncalibrated,
                                      {}};
                for (const auto& [point, feature] : feature_of[first]) {
                    // As seen by cameras that go around the other way than the sides are numbered.
                    const std::size_t like = (point + (kSides - sides % kSides) * of_one_side) %
                                             scene_.truth.points.size();
                    const auto seen = feature_of[second].find(like);
                    if (seen != feature_of[second].end())
                        mistaken.inliers.push_back({feature, seen->second});
                }
                mistaken_ += mistaken.inliers.size() >= 30 ? 1 : 0;
                matched_.pairs.push_back(std::move(mistaken));
            }
    }

    /// The truth, with the second half of the photographs put where those a side before were taken.
    [[nodiscard]] Capture folded() const {
        Capture folded = scene_.truth;
        const Rigid3 turn{Eigen::Quaterniond(turn_to_next_side()), Eigen::Vector3d::Zero()};
        for (std::size_t view = folded.views.size() / 2; view < folded.views.size(); ++view)
            folded.views[view].cam_from_world = folded.views[view].cam_from_world * turn;
        return folded;
    }

    /// As if photograph `i` had been taken as the one at `place_of[i]`, and bore its name.
    void put_in_order(const std::vector<int>& place_of) {
        std::vector<ColmapPhotograph> matched(photographs_.size());
        for (std::size_t i = 0; i < photographs_.size(); ++i) {
            const auto place = static_cast<std::size_t>(place_of[i]);
            matched[place] = matched_.photographs[i];
            scene_.truth.views[i].name = photographs_[place].name;
        }
        matched_.photographs = std::move(matched);
        for (VerifiedPair& pair : matched_.pairs) {
            pair.first = place_of[static_cast<std::size_t>(pair.first)];
            pair.second = place_of[static_cast<std::size_t>(pair.second)];
            if (pair.first < pair.second) continue;
            std::swap(pair.first, pair.second);
            for (FeatureMatch& match : pair.inliers) std::swap(match.first, match.second);
        }
    }

    std::optional<SecondModel> asked(const Capture& refined) {
        return find_model_in_order(job(), matched_, LensPolicy::kHeld, refined);
    }

    int mistaken_ = 0;
};

TEST_F(FourSides, AreToldApartByTheOrderOfThePhotographs) {
    mistake_sides();
    ASSERT_GT(mistaken_, 50);
    const std::size_t pairs = matched_.pairs.size();
    const auto model = asked(folded());
    ASSERT_TRUE(model.has_value());
    EXPECT_EQ(model->refined.views.size(), 36u);
    EXPECT_LT(relative_position_error(model->refined, scene_.truth), 1e-3);
    EXPECT_EQ(model->joint_trouble, "");
    EXPECT_THAT(model->warning, testing::HasSubstr("E-POSES-REPEATED"));
    EXPECT_LT(matched_.pairs.size(), pairs - 50) << "what was mistaken is forgotten";
    for (const JudgedPair& pair :
         judge_pairs(scene_.truth, photographs_, matched_.photographs, matched_.pairs, progress_))
        EXPECT_TRUE(pair.is_agreeing()) << pair.index;
}

TEST_F(FourSides, AreNotAskedAboutWhereNothingContradictsTheModel) {
    EXPECT_FALSE(asked(scene_.truth).has_value());
}

/// As if the last photographs had shared too little with the others to be placed.
Capture without_the_last(Capture capture, std::size_t missing) {
    capture.views.resize(capture.views.size() - missing);
    const int views = static_cast<int>(capture.views.size());
    for (ScenePoint& point : capture.points)
        std::erase_if(point.track,
                      [&](const Observation& seen) { return seen.view_index >= views; });
    std::erase_if(capture.points, [](const ScenePoint& point) { return point.track.size() < 2; });
    return capture;
}

TEST_F(FourSides, ArePlacedByTheOrderOfThePhotographsWhereManyAreMissing) {
    const auto model = asked(without_the_last(scene_.truth, 9));
    ASSERT_TRUE(model.has_value());
    EXPECT_EQ(model->refined.views.size(), 36u);
    EXPECT_LT(relative_position_error(model->refined, scene_.truth), 1e-3);
    EXPECT_THAT(model->warning, testing::StartsWith("9 photographs share so little"));
}

TEST_F(FourSides, AreNotAskedAboutWhereFewPhotographsAreMissing) {
    EXPECT_FALSE(asked(without_the_last(scene_.truth, 7)).has_value());
}

TEST_F(FourSides, AreNotMappedAnewForNoMorePhotographsThanBefore) {
    const Capture some = without_the_last(scene_.truth, 9);
    for (VerifiedPair& pair : matched_.pairs)
        if (pair.second >= static_cast<int>(some.views.size())) pair.inliers.clear();
    EXPECT_FALSE(asked(some).has_value());
}

TEST_F(FourSides, AreLeftInDoubtWherePhotographsAreInNoOrder) {
    mistake_sides();
    std::vector<int> place_of(kPhotographs);
    std::iota(place_of.begin(), place_of.end(), 0);
    std::mt19937 random(3);
    std::shuffle(place_of.begin(), place_of.end(), random);
    put_in_order(place_of);
    EXPECT_FALSE(asked(folded()).has_value());
}

TEST_F(FourSides, AreLeftInDoubtWhereAllWerePhotographedBeforeTheNextStep) {
    mistake_sides();
    std::vector<int> place_of;
    for (int i = 0; i < kPhotographs; ++i)
        place_of.push_back(i % static_cast<int>(kOfOneSide) * kSides +
                           i / static_cast<int>(kOfOneSide));
    put_in_order(place_of);
    const std::size_t pairs = matched_.pairs.size();
    EXPECT_FALSE(asked(folded()).has_value());
    EXPECT_EQ(matched_.pairs.size(), pairs) << "nothing is forgotten where nothing was learnt";
}

TEST_F(FourSides, WereFoldedWherePhotographsThatFollowEachOtherSayOtherwise) {
    const auto agreement_of = [&](const Capture& model) {
        return compare_with_pairs(model, photographs_, matched_.photographs, matched_.pairs,
                                  progress_);
    };
    EXPECT_EQ(agreement_of(scene_.truth).in_order, 35);
    EXPECT_EQ(agreement_of(scene_.truth).doubtful_in_order, 0);
    EXPECT_FALSE(agreement_of(scene_.truth).is_contradiction());
    EXPECT_EQ(agreement_of(folded()).doubtful_in_order, 1) << "where the second half begins";
}

TEST(PairAgreement, IsDeniedByTwoPairsThatFollowEachOtherThoughAllPairsTogetherHardlyDo) {
    // A box with a small mark, folded (16 photographs).
    PairAgreement agreement;
    agreement.pairs = 118;
    agreement.agreeing_share = 0.955;
    agreement.in_order = 15;
    agreement.doubtful_in_order = 1;
    EXPECT_FALSE(agreement.is_contradiction());
    agreement.doubtful_in_order = 2;
    EXPECT_TRUE(agreement.is_contradiction());
    agreement.in_order = 100;
    EXPECT_FALSE(agreement.is_contradiction()) << "a fiftieth of them";
}

}  // namespace
}  // namespace lumi
