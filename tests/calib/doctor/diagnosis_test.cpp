#include "calib/doctor/diagnosis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/doctor/match_graph_picture.h"

namespace lumi {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr int kPhotographs = 8;

PairGeometry pair_between(int first, int second) {
    PairGeometry pair;
    pair.pair = {first, second, PairConfiguration::kUncalibrated, std::vector<FeatureMatch>(200)};
    pair.median_angle_deg = 5;
    return pair;
}

/// Sharp, well lit photographs that all show the same things from different places.
CaptureEvidence good_capture() {
    CaptureEvidence evidence;
    evidence.width_px = 800;
    PhotographQuality quality;
    quality.longer_side_px = 800;
    quality.mean_linear = 0.2;
    quality.noise_sigma = 1;
    quality.signal_to_noise = 40;
    quality.detail = {10, 12, 12, 12};
    quality.features = 900;
    for (int index = 0; index < kPhotographs; ++index) {
        quality.name = "p" + std::to_string(index) + ".jpg";
        evidence.photographs.push_back(quality);
        for (int other = 0; other < index; ++other) {
            evidence.pairs.push_back(pair_between(other, index));
            evidence.inlier_shares.push_back(0.8);
        }
    }
    evidence.motion.pairs = static_cast<int>(evidence.pairs.size());
    evidence.loops.closed = 5000;
    return evidence;
}

void lose_all_pairs(CaptureEvidence& evidence) {
    evidence.pairs.clear();
    evidence.inlier_shares.clear();
    evidence.motion = {};
    evidence.loops = {};
}

Finding first_finding(const CaptureEvidence& evidence) {
    const std::vector<Finding> findings = diagnose(evidence);
    EXPECT_THAT(findings, Not(IsEmpty()));
    return findings.empty() ? Finding{} : findings.front();
}

TEST(Diagnosis, HasNothingAgainstAGoodCapture) { EXPECT_THAT(diagnose(good_capture()), IsEmpty()); }

TEST(Diagnosis, NamesTheCauseBeforeTheEffect) {
    CaptureEvidence evidence = good_capture();
    lose_all_pairs(evidence);
    for (PhotographQuality& quality : evidence.photographs) quality.detail = {0.2, 0.3, 0.4, 0.4};
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kTexture);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
}

TEST(Diagnosis, WithoutACauseItSaysThatNoPairIsThere) {
    CaptureEvidence evidence = good_capture();
    lose_all_pairs(evidence);
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kNoPair);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
}

TEST(Diagnosis, PoorPicturesThatStillMatchAreOnlyANote) {
    CaptureEvidence evidence = good_capture();
    for (PhotographQuality& quality : evidence.photographs) quality.blur_sigma_px = 9;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kBlur);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kNote);
    lose_all_pairs(evidence);
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kBlur);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
}

TEST(Diagnosis, TellsNoiseFromBlackAndWhite) {
    CaptureEvidence noisy = good_capture();
    lose_all_pairs(noisy);
    for (PhotographQuality& quality : noisy.photographs) {
        quality.noise_sigma = 60;
        quality.signal_to_noise = 1.5;
    }
    EXPECT_EQ(first_finding(noisy).reason, CaptureReason::kNoise);
    CaptureEvidence overexposed = good_capture();
    lose_all_pairs(overexposed);
    for (PhotographQuality& quality : overexposed.photographs) quality.clipped_share = 0.8;
    EXPECT_EQ(first_finding(overexposed).reason, CaptureReason::kExposure);
}

TEST(Diagnosis, NamesThePhotographsWhoseBrightnessJumps) {
    CaptureEvidence evidence = good_capture();
    evidence.photographs[3].mean_linear = 0.01;
    const Finding finding = first_finding(evidence);
    EXPECT_EQ(finding.reason, CaptureReason::kExposure);
    EXPECT_THAT(finding.photographs, testing::ElementsAre("p3.jpg"));
}

TEST(Diagnosis, OneDarkPhotographIsNotWhyTheOthersDoNotHangTogether) {
    CaptureEvidence evidence = good_capture();
    evidence.photographs[3].mean_linear = 0.02;
    std::erase_if(evidence.pairs, [](const PairGeometry& pair) {
        return pair.pair.first == 3 || pair.pair.second == 3;
    });
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kExposure) << "it is why it is lost";
    EXPECT_EQ(first_finding(evidence).severity, Severity::kRisk);

    evidence.pairs = {pair_between(0, 1), pair_between(4, 5)};
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kSplit);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
}

TEST(Diagnosis, NamesThePhotographsOutsideOfTheLargestGroup) {
    CaptureEvidence evidence = good_capture();
    std::erase_if(evidence.pairs, [](const PairGeometry& pair) {
        return (pair.pair.first < 5) != (pair.pair.second < 5);
    });
    const Finding finding = first_finding(evidence);
    EXPECT_EQ(finding.reason, CaptureReason::kSplit);
    EXPECT_EQ(finding.severity, Severity::kRisk);
    EXPECT_THAT(finding.photographs, testing::ElementsAre("p5.jpg", "p6.jpg", "p7.jpg"));
}

TEST(Diagnosis, ACameraThatOnlyTurnedIsHopeless) {
    CaptureEvidence evidence = good_capture();
    evidence.motion.rotation_pairs = evidence.motion.planar_pairs = evidence.motion.pairs;
    evidence.motion.turned_share = 0.95;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kNoParallax);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
}

TEST(Diagnosis, WhereSomePairsShowParallaxSeemingRotationsAreANote) {
    CaptureEvidence evidence = good_capture();
    evidence.motion.rotation_pairs = evidence.motion.pairs * 4 / 5;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kNoParallax);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kNote);
}

TEST(Diagnosis, OnePairAmongManyPhotographsSaysNothingOfTheMotion) {
    CaptureEvidence evidence = good_capture();
    evidence.pairs.resize(1);
    evidence.motion = {1, 1, 1};
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kSplit);
}

TEST(Diagnosis, AFlatSurfaceIsANoteBecausePosesComeOutAllTheSame) {
    CaptureEvidence evidence = good_capture();
    evidence.motion.planar_pairs = evidence.motion.pairs;
    EXPECT_THAT(diagnose(evidence), IsEmpty()) << "a fifth of the matches is off the plane";
    evidence.inlier_shares.assign(evidence.inlier_shares.size(), 0.97);
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kPlanar);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kNote);
}

TEST(Diagnosis, TellsThingsThatMoveFromThingsThatLookAlike) {
    CaptureEvidence moving = good_capture();
    moving.inlier_shares.assign(moving.inlier_shares.size(), 0.2);
    EXPECT_EQ(first_finding(moving).reason, CaptureReason::kClutter);
    CaptureEvidence alike = good_capture();
    alike.loops = {3000, 2000};
    EXPECT_EQ(first_finding(alike).reason, CaptureReason::kRepeated);
}

TEST(Diagnosis, FewPlacesPhotographedManyTimesAreDuplicates) {
    CaptureEvidence evidence = good_capture();
    evidence.duplicates_left_out = 20;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kDuplicates);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kRisk);
    evidence.duplicates_left_out = 2;
    EXPECT_EQ(first_finding(evidence).severity, Severity::kNote);
}

TEST(Diagnosis, TwoPhotographsAreHopelessUnlessTheirLensesAreKnown) {
    CaptureEvidence evidence = good_capture();
    evidence.photographs.resize(2);
    evidence.pairs = {pair_between(0, 1)};
    evidence.inlier_shares = {0.8};
    evidence.motion.pairs = 1;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kFew);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
    // To accept a smaller share of two photographs does not help.
    EXPECT_THAT(std::string(advice_for(CaptureReason::kFew)),
                Not(HasSubstr("min_registered_share")));
    evidence.focal_lengths_are_known = true;
    EXPECT_THAT(diagnose(evidence), IsEmpty());
}

TEST(Diagnosis, OnePhotographIsHopelessAlsoWhereOthersRepeatIt) {
    CaptureEvidence evidence = good_capture();
    lose_all_pairs(evidence);
    evidence.photographs.resize(1);
    evidence.focal_lengths_are_known = true;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kFew);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
    evidence.duplicates_left_out = 9;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kDuplicates);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
}

TEST(Diagnosis, FewerThanABuildIsToldToAcceptAreHopeless) {
    CaptureEvidence evidence = good_capture();
    evidence.min_photographs = kPhotographs + 1;
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kFew);
    EXPECT_EQ(first_finding(evidence).severity, Severity::kHopeless);
    EXPECT_THAT(first_finding(evidence).what,
                HasSubstr("8 usable photographs, expected at least 9 ([capture] min_photographs)"));
    EXPECT_THAT(std::string(advice_for(CaptureReason::kFew)),
                testing::Not(HasSubstr("min_registered_share")));
    evidence.min_photographs = kPhotographs;
    EXPECT_THAT(diagnose(evidence), IsEmpty());
}

TEST(Diagnosis, OnePhotographIsToldInTheSingular) {
    CaptureEvidence evidence = good_capture();
    lose_all_pairs(evidence);
    evidence.photographs.resize(1);
    EXPECT_THAT(first_finding(evidence).what, HasSubstr(": 1 usable photograph, expected"));
    evidence.duplicates_left_out = 1;
    EXPECT_THAT(first_finding(evidence).what,
                HasSubstr("1 photograph repeats another one; 1 different one is left"));
}

TEST(Diagnosis, ASmallPictureIsBlurredByFewerPixels) {
    CaptureEvidence evidence = good_capture();
    for (PhotographQuality& quality : evidence.photographs) quality.blur_sigma_px = 4;
    EXPECT_THAT(diagnose(evidence), IsEmpty());
    evidence.photographs[5].longer_side_px = 400;
    ASSERT_THAT(diagnose(evidence), testing::SizeIs(1));
    EXPECT_EQ(first_finding(evidence).reason, CaptureReason::kBlur);
    EXPECT_THAT(first_finding(evidence).photographs, testing::ElementsAre("p5.jpg"));
}

TEST(Diagnosis, EveryReasonHasACodeAndAdviceOfItsOwn) {
    for (int index = 0; index <= static_cast<int>(CaptureReason::kUncertain); ++index) {
        const auto reason = static_cast<CaptureReason>(index);
        EXPECT_EQ(reason_with_code(code_of(reason)), reason);
        EXPECT_THAT(std::string(code_of(reason)), testing::StartsWith("E-POSES-"));
        EXPECT_FALSE(advice_for(reason).empty());
    }
    EXPECT_FALSE(reason_with_code("E-INGEST-TOOFEW").has_value());
}

TEST(MatchGraphPicture, ShowsEveryPhotographAndPairAndEscapesNames) {
    CaptureEvidence evidence = good_capture();
    evidence.photographs[0].name = "<a&b>.jpg";
    const std::string svg = match_graph_svg(evidence);
    EXPECT_THAT(svg, HasSubstr("&lt;a&amp;b&gt;.jpg"));
    std::size_t lines = 0;
    for (std::size_t at = svg.find("<path"); at != std::string::npos;
         at = svg.find("<path", at + 1))
        ++lines;
    EXPECT_EQ(lines, evidence.pairs.size());
}

}  // namespace
}  // namespace lumi
