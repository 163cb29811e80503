// What a model that looks right and is wrong gives away.
#include <gtest/gtest.h>

#include <random>

#include "calib/adjust/bundle_adjustment.h"
#include "calib/poses/pair_agreement.h"
#include "calib/poses/pose_shift.h"
#include "calib/poses/residual_pattern.h"
#include "calib/poses/supposed_adjustment.h"
#include "calib/work/error.h"
#include "tests/calib/adjust/synthetic_capture.h"
#include "tests/calib/interrupted_progress.h"

namespace lumi {
namespace {

const Camera kDoubtedCamera = pinhole_camera(1000, 800, 900);

Capture noisy_capture(unsigned seed) {
    SyntheticCaptureOptions scene;
    scene.noise_px = 0.5;
    scene.seed = seed;
    return synthetic_capture(kDoubtedCamera, scene);
}

/// A turn for each view (rad, in its axes), of root mean square `skew_px` in pictures: those of
/// hands, which neither the cameras' axes nor the world's have in common.
std::vector<Eigen::Vector3d> turns_of_hands(const Capture& capture, double skew_px) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> heading(0.0, 6.28);
    const auto views = static_cast<Eigen::Index>(capture.views.size());
    Eigen::VectorXd turns(3 * views);
    Eigen::MatrixXd in_common(3 * views, 6);
    for (Eigen::Index view = 0; view < views; ++view) {
        const double angle = heading(random);
        turns.segment<3>(3 * view) = Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
        in_common.middleRows<3>(3 * view) << Eigen::Matrix3d::Identity(),
            capture.views[static_cast<std::size_t>(view)]
                .cam_from_world.rotation.toRotationMatrix();
    }
    turns -= in_common * in_common.colPivHouseholderQr().solve(turns);
    turns *= skew_px / 900 * std::sqrt(static_cast<double>(views)) / turns.norm();
    std::vector<Eigen::Vector3d> of_views;
    for (Eigen::Index view = 0; view < views; ++view) {
        of_views.emplace_back(turns.segment<3>(3 * view));
    }
    return of_views;
}

/// Moves what each view saw as if the camera had turned while the rows were read.
void skew(Capture& capture, const std::vector<Eigen::Vector3d>& turns) {
    for (ScenePoint& point : capture.points) {
        for (Observation& seen : point.track) {
            const auto view = static_cast<std::size_t>(seen.view_index);
            const Eigen::Vector3d at_middle =
                capture.views[view].cam_from_world * point.position_in_world;
            const double time = seen.pixel.y() / 800 - 0.5;
            const Eigen::Vector3d turned = at_middle + time * turns[view].cross(at_middle);
            seen.pixel += *project(kDoubtedCamera, turned) - *project(kDoubtedCamera, at_middle);
        }
    }
}

void skew(Capture& capture, double skew_px) { skew(capture, turns_of_hands(capture, skew_px)); }

/// Moves what each view saw as if its picture had been cut out with its middle so far away, and
/// scaled by a few hundredths. Returns where each view's middle then is (px, from where it was).
std::vector<Eigen::Vector2d> crop(Capture& capture, double shift_px) {
    std::vector<Eigen::Vector2d> shifts;
    std::mt19937 random(6);
    std::uniform_real_distribution<double> heading(0.0, 6.28);
    std::uniform_real_distribution<double> scale(0.97, 1.03);
    for (std::size_t index = 0; index < capture.views.size(); ++index) {
        const double angle = heading(random);
        const Eigen::Vector2d shift = shift_px * Eigen::Vector2d(std::cos(angle), std::sin(angle));
        const double factor = scale(random);
        shifts.push_back(shift);
        for (ScenePoint& point : capture.points) {
            for (Observation& seen : point.track) {
                if (seen.view_index != static_cast<int>(index)) continue;
                seen.pixel = principal_point_px(kDoubtedCamera) + shift +
                             factor * (seen.pixel - principal_point_px(kDoubtedCamera));
            }
        }
    }
    return shifts;
}

SupposedAdjustment adjusted(Supposition supposition, const Capture& capture, bool lenses_are_held) {
    SilentProgress progress;
    return adjust_supposing(supposition, capture,
                            lenses_are_held ? SupposedLens::kHeld : SupposedLens::kMiddleHeld, 2.0,
                            progress);
}

TEST(ResidualPattern, NoiseHasNone) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const ResidualPattern pattern = residual_pattern(noisy_capture(seed));
        EXPECT_LT(pattern.shutter_ratio, 2.0) << seed;
        EXPECT_LT(pattern.zoom_ratio, 3.0) << seed;
    }
}

/// What an adjustment leaves, which nothing was told of a cause.
ResidualPattern adjusted_pattern(Capture capture) {
    SilentProgress progress;
    BundleAdjustmentOptions options;
    options.max_reprojection_error_px = 8;
    adjust_bundle(capture, options, progress);
    return residual_pattern(capture);
}

TEST(ResidualPattern, TellsARollingShutterFromZoom) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        Capture skewed = noisy_capture(seed);
        skew(skewed, 12);
        const ResidualPattern of_skew = adjusted_pattern(skewed);
        EXPECT_TRUE(of_skew.is_suspicious()) << seed << ": " << of_skew.shutter_ratio;
        EXPECT_FALSE(of_skew.is_zoomed()) << seed << ": " << of_skew.zoom_ratio;
        Capture zoomed = noisy_capture(seed);
        for (ScenePoint& point : zoomed.points) {
            for (Observation& seen : point.track) {
                if (seen.view_index % 2 == 0) continue;
                seen.pixel += 0.02 * (seen.pixel - principal_point_px(kDoubtedCamera));
            }
        }
        const ResidualPattern of_zoom = adjusted_pattern(zoomed);
        EXPECT_TRUE(of_zoom.is_zoomed())
            << seed << ": " << of_zoom.zoom_ratio << ", " << of_zoom.shutter_ratio;
    }
}

TEST(ResidualPattern, TheCriterionAsksForMoreThanChanceGives) {
    // Thirty parameters that explain nothing take away thirty residuals' worth of a thousand.
    EXPECT_FALSE(explains_better(1000, 970, 30, 500));
    EXPECT_TRUE(explains_better(1000, 500, 30, 500));
}

TEST(SupposedAdjustment, FindsTheSkewOfARollingShutterAndTheTruePoses) {
    Capture capture = noisy_capture(4);
    const NamedPoses truth = named_poses(capture);
    skew(capture, 30);
    const SupposedAdjustment steady = adjusted(Supposition::kSteady, capture, true);
    const SupposedAdjustment turning = adjusted(Supposition::kTurning, capture, true);
    EXPECT_NEAR(turning.effect_px, 30, 6);
    const PoseShift shift = pose_shift(named_poses(turning.capture), truth);
    EXPECT_EQ(shift.placed, 8);
    EXPECT_LT(shift.position_share, 0.02);
    EXPECT_LT(turning.cost_px2, 2 * 0.3 * static_cast<double>(turning.observations));
    EXPECT_TRUE(explains_better(steady.cost_px2, turning.cost_px2, turning.parameters,
                                turning.observations));
    EXPECT_LT(turning.cost_px2, adjusted(Supposition::kShifted, capture, true).cost_px2);
}

TEST(SupposedAdjustment, FindsNoRollingShutterInWhatAllPicturesHaveInCommon) {
    const Eigen::Vector3d turn(-40.0 / 900, 0, 0);
    const std::vector<Eigen::Vector3d> in_cameras(8, turn);
    std::vector<Eigen::Vector3d> in_world;
    for (const View& view : noisy_capture(4).views) {
        in_world.emplace_back(view.cam_from_world.rotation * turn);
    }
    for (const std::vector<Eigen::Vector3d>& turns : {in_cameras, in_world}) {
        Capture capture = noisy_capture(4);
        skew(capture, turns);
        const SupposedAdjustment steady = adjusted(Supposition::kSteady, capture, false);
        const SupposedAdjustment turning = adjusted(Supposition::kTurning, capture, false);
        EXPECT_LT(turning.effect_px, 40.0 / 5);
        EXPECT_FALSE(
            pose_shift(named_poses(steady.capture), named_poses(turning.capture)).matters());
    }
}

TEST(SupposedAdjustment, APictureCutElsewhereIsThatOfACameraThatIsTurned) {
    Capture capture = noisy_capture(4);
    Capture turned = capture;
    const std::vector<Eigen::Vector2d> shifts = crop(capture, 60);
    for (std::size_t view = 0; view < turned.views.size(); ++view) {
        const Eigen::Vector3d middle(shifts[view].x(), shifts[view].y(), 900);
        Rigid3& pose = turned.views[view].cam_from_world;
        pose = Rigid3{Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), middle),
                      Eigen::Vector3d::Zero()} *
               pose;
    }
    const SupposedAdjustment cropped = adjusted(Supposition::kShifted, capture, true);
    const PoseShift shift = pose_shift(named_poses(cropped.capture), named_poses(turned));
    EXPECT_LT(shift.rotation_deg, 1.0) << "the cuts alone are 3.8 degrees";
    EXPECT_LT(shift.position_share, 0.02);
}

TEST(SupposedAdjustment, FindsTheCutsOfCroppedPhotographsAndTheTruePoses) {
    Capture capture = noisy_capture(4);
    const NamedPoses truth = named_poses(capture);
    (void)crop(capture, 60);
    EXPECT_GT(residual_pattern(capture).shutter_ratio, 4.0);
    const SupposedAdjustment cropped = adjusted(Supposition::kShifted, capture, true);
    EXPECT_NEAR(cropped.effect_px, 60, 12);
    const PoseShift shift = pose_shift(named_poses(cropped.capture), truth);
    EXPECT_EQ(shift.placed, 8);
    EXPECT_LT(shift.position_share, 0.02);
    EXPECT_LT(cropped.cost_px2, 2 * 0.3 * static_cast<double>(cropped.observations));
    EXPECT_LT(cropped.cost_px2, adjusted(Supposition::kTurning, capture, true).cost_px2);
    EXPECT_FALSE(cropped.is_mostly_common());
}

TEST(SupposedAdjustment, TellsACutThatAllPicturesShare) {
    Capture capture = noisy_capture(4);
    for (ScenePoint& point : capture.points) {
        for (Observation& seen : point.track) seen.pixel += Eigen::Vector2d(36, 48);
    }
    const SupposedAdjustment cropped = adjusted(Supposition::kShifted, capture, true);
    // Turned cameras and bent points make up for most of it.
    EXPECT_LT(cropped.effect_px, 60);
    EXPECT_TRUE(cropped.is_mostly_common());
}

TEST(SupposedAdjustment, ExplainsNothingOfSteadyCamerasWithWholePhotographs) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const Capture capture = noisy_capture(seed);
        const SupposedAdjustment steady = adjusted(Supposition::kSteady, capture, false);
        for (const Supposition other : {Supposition::kTurning, Supposition::kShifted}) {
            const SupposedAdjustment supposed = adjusted(other, capture, false);
            EXPECT_FALSE(explains_better(steady.cost_px2, supposed.cost_px2, supposed.parameters,
                                         supposed.observations))
                << seed;
        }
    }
}

/// A lens that sees 70 degrees off its axis, amid the cloud.
Capture through_fisheye(unsigned seed) {
    const Camera fisheye{
        1100, 1100, LensModel::kOpenCvFisheye, {420, 420, 550, 550, 0.02, 0, 0, 0}};
    return synthetic_capture(fisheye,
                             {.points = 600, .noise_px = 0.1, .arc_radius = 1.3, .seed = seed});
}

TEST(SupposedAdjustment, TakesNoFisheyeForARollingShutter) {
    for (const unsigned seed : {1u, 2u}) {
        const Capture capture = through_fisheye(seed);
        double widest_px = 0;
        for (const ScenePoint& point : capture.points)
            for (const Observation& seen : point.track)
                widest_px = std::max(widest_px,
                                     (seen.pixel - principal_point_px(capture.cameras[0])).norm());
        ASSERT_GT(widest_px, 420) << "the lens must bend what is seen";
        const SupposedAdjustment steady = adjusted(Supposition::kSteady, capture, false);
        EXPECT_LT(steady.cost_px2, 2 * 0.011 * static_cast<double>(steady.observations));
        for (const Supposition other : {Supposition::kTurning, Supposition::kShifted}) {
            const SupposedAdjustment supposed = adjusted(other, capture, false);
            EXPECT_FALSE(explains_better(steady.cost_px2, supposed.cost_px2, supposed.parameters,
                                         supposed.observations))
                << seed;
        }
    }
}

TEST(PoseShift, IsNothingAfterASimilarity) {
    const Capture capture = synthetic_capture(kDoubtedCamera, {});
    NamedPoses moved;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
    for (const auto& [name, pose] : named_poses(capture)) {
        const Eigen::Quaterniond rotation = pose.rotation * turn.conjugate();
        const Eigen::Vector3d centre =
            3.0 * (turn * centre_in_world(pose)) + turn * Eigen::Vector3d::UnitX();
        moved[name] = {rotation, -(rotation * centre)};
    }
    const PoseShift shift = pose_shift(moved, named_poses(capture));
    EXPECT_LT(shift.position_share, 1e-9);
    EXPECT_LT(shift.rotation_deg, 1e-5);
}

TEST(PoseShift, SeesOneCameraThatIsElsewhere) {
    const Capture capture = synthetic_capture(kDoubtedCamera, {});
    NamedPoses moved = named_poses(capture);
    moved.begin()->second.translation += Eigen::Vector3d(0.8, 0, 0);
    EXPECT_GT(pose_shift(moved, named_poses(capture)).position_share, 0.1);
}

TEST(PoseShift, CamerasOnALineAreComparedAsWell) {
    NamedPoses line;
    for (int index = 0; index < 5; ++index) {
        line["v" + std::to_string(index)] = {Eigen::Quaterniond::Identity(),
                                             Eigen::Vector3d(-index, 0, 0)};
    }
    EXPECT_LT(pose_shift(line, line).rotation_deg, 1e-6);
}

/// All pairs of views, matched by the points they share.
struct PairsOfCapture {
    std::vector<Photograph> photographs;
    std::vector<ColmapPhotograph> features;
    std::vector<VerifiedPair> pairs;

    explicit PairsOfCapture(const Capture& capture) {
        for (const View& view : capture.views) {
            Photograph photograph;
            photograph.name = view.name;
            photographs.push_back(photograph);
        }
        features.resize(capture.views.size());
        std::vector<std::vector<int>> feature_of(capture.views.size(),
                                                 std::vector<int>(capture.points.size(), -1));
        for (std::size_t point = 0; point < capture.points.size(); ++point) {
            for (const Observation& seen : capture.points[point].track) {
                const auto view = static_cast<std::size_t>(seen.view_index);
                feature_of[view][point] = static_cast<int>(features[view].keypoints_px.size());
                features[view].keypoints_px.push_back(seen.pixel.cast<float>());
            }
        }
        for (int first = 0; first < static_cast<int>(capture.views.size()); ++first) {
            for (int second = first + 1; second < static_cast<int>(capture.views.size());
                 ++second) {
                VerifiedPair pair{first, second, PairConfiguration::kUncalibrated, {}};
                for (std::size_t point = 0; point < capture.points.size(); ++point) {
                    const int a = feature_of[static_cast<std::size_t>(first)][point];
                    const int b = feature_of[static_cast<std::size_t>(second)][point];
                    if (a < 0 || b < 0) continue;
                    pair.inliers.push_back(
                        {static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
                }
                pairs.push_back(pair);
            }
        }
    }
    [[nodiscard]] PairAgreement with(const Capture& capture) const {
        return compare_with_pairs(capture, photographs, features, pairs, SilentProgress());
    }
};

TEST(SupposedAdjustment, StopsBetweenTwoStepsOnRequest) {
    EXPECT_THROW(
        static_cast<void>(adjust_supposing(Supposition::kSteady, noisy_capture(6),
                                           SupposedLens::kMiddleHeld, 2.0, InterruptedProgress(2))),
        Error);
}

TEST(PairAgreement, ATrueModelDeniesNoPair) {
    const Capture capture = noisy_capture(6);
    const PairAgreement agreement = PairsOfCapture(capture).with(capture);
    EXPECT_EQ(agreement.pairs, 28);
    EXPECT_EQ(agreement.contradicted, 0);
    EXPECT_GT(agreement.agreeing_share, 0.99);
    EXPECT_FALSE(agreement.is_contradiction());
}

TEST(PairAgreement, ACameraPutElsewhereDeniesItsPairs) {
    const Capture capture = noisy_capture(6);
    const PairsOfCapture pairs(capture);
    Capture wrong = capture;
    // Where the camera opposite stands, with the height of its own.
    wrong.views[0].cam_from_world = capture.views[5].cam_from_world;
    wrong.views[0].cam_from_world.translation.y() += 1.0;
    const PairAgreement agreement = pairs.with(wrong);
    EXPECT_GE(agreement.contradicted, 5);
    EXPECT_GT(agreement.contradicted_share, 0.15);
    EXPECT_TRUE(agreement.is_contradiction());
    EXPECT_TRUE(agreement.is_mistaken());
}

TEST(PairAgreement, CamerasAtOnePlaceAgreeOnlyWithMatchesThatATurnExplains) {
    Capture capture = noisy_capture(6);
    const PairsOfCapture pairs(capture);
    for (View& view : capture.views) {
        view.cam_from_world.translation.setZero();
    }
    const PairAgreement agreement = pairs.with(capture);
    EXPECT_EQ(agreement.contradicted, agreement.pairs);
    // What two cameras at one place see of points that are infinitely far away.
    for (ScenePoint& point : capture.points) {
        for (Observation& seen : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
            const Eigen::Vector3d direction(point.position_in_world.x(),
                                            point.position_in_world.y(), 4);
            seen.pixel = project(camera_of(capture, view), direction).value();
        }
    }
    for (View& view : capture.views) view.cam_from_world = {};
    EXPECT_EQ(PairsOfCapture(capture).with(capture).agreeing_share, 1.0);
}

/// Far from the origin, as on a map. The second sees points where it would if it stood half a unit
/// away in the very direction that rounding tells.
TEST(PairAgreement, WhatRoundingLeavesBetweenCamerasAtOnePlaceIsNoBaseLine) {
    Capture capture = noisy_capture(6);
    capture.views.resize(2);
    capture.points.clear();
    for (View& view : capture.views) {
        view.cam_from_world.translation =
            -(view.cam_from_world.rotation * Eigen::Vector3d(300000, 5000000, 200));
    }
    const Rigid3& first = capture.views[0].cam_from_world;
    const Rigid3& second = capture.views[1].cam_from_world;
    const Rigid3 second_from_first = second * inverse(first);
    ASSERT_GT(second_from_first.translation.norm(), 0);
    const Eigen::Vector3d base_line = 0.5 * second_from_first.translation.normalized();
    for (int i = 0; i < 49; ++i) {
        const Eigen::Vector3d in_first(0.2 * (i % 7 - 3), 0.2 * (i / 7 - 3), 4);
        const Eigen::Vector3d in_second = second_from_first.rotation * in_first + base_line;
        ScenePoint point;
        point.track = {{0, project(capture.cameras[0], in_first).value()},
                       {1, project(capture.cameras[0], in_second).value()}};
        capture.points.push_back(std::move(point));
    }
    const PairAgreement agreement = PairsOfCapture(capture).with(capture);
    EXPECT_EQ(agreement.pairs, 1);
    EXPECT_EQ(agreement.contradicted, 1);
}

TEST(PairAgreement, ComparisonStopsOnRequest) {
    const Capture capture = noisy_capture(6);
    const PairsOfCapture all(capture);
    SilentProgress progress;
    progress.interrupt();
    EXPECT_THROW(static_cast<void>(compare_with_pairs(capture, all.photographs, all.features,
                                                      all.pairs, progress)),
                 Error);
}

/// As of windows of one house: of the first so many matches of some pairs each point is taken for
/// another one; the others are not found.
PairsOfCapture with_lookalikes(const Capture& capture, std::size_t matches) {
    PairsOfCapture all(capture);
    for (VerifiedPair& pair : all.pairs) {
        if (pair.second - pair.first != 4) continue;
        EXPECT_GT(pair.inliers.size(), matches);
        const std::vector<FeatureMatch> right = pair.inliers;
        pair.inliers.resize(matches);
        for (std::size_t i = 0; i < matches; ++i)
            pair.inliers[i].second = right[(i + right.size() / 2) % right.size()].second;
    }
    return all;
}

TEST(PairAgreement, WhatLooksAlikeIsOutweighedByChainsOfFarMoreMatches) {
    const Capture capture = noisy_capture(6);
    const PairAgreement agreement = with_lookalikes(capture, 32).with(capture);
    EXPECT_EQ(agreement.outweighed, 4);
    EXPECT_EQ(agreement.pairs, 24);
    EXPECT_EQ(agreement.contradicted, 0);
    EXPECT_FALSE(agreement.is_contradiction());
}

TEST(PairAgreement, WhatAsManyMatchesSayIsNotOutweighed) {
    const Capture capture = noisy_capture(6);
    const std::size_t many = PairsOfCapture(capture).pairs.front().inliers.size() * 3 / 4;
    const PairAgreement agreement = with_lookalikes(capture, many).with(capture);
    EXPECT_EQ(agreement.outweighed, 0);
    EXPECT_EQ(agreement.contradicted, 4);
    EXPECT_TRUE(agreement.is_contradiction());
}

TEST(PairAgreement, ACameraThatIsTurnedALittleIsDeniedButNotMistaken) {
    const Capture capture = noisy_capture(6);
    const PairsOfCapture pairs(capture);
    Capture bent = capture;
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()));
    Rigid3& pose = bent.views[0].cam_from_world;
    pose = {turn * pose.rotation, turn * pose.translation};
    const PairAgreement agreement = pairs.with(bent);
    EXPECT_TRUE(agreement.is_contradiction());
    EXPECT_NEAR(agreement.contradicted_turn_deg, 5.7, 1.0);
    EXPECT_FALSE(agreement.is_mistaken());
}

}  // namespace
}  // namespace lumi
