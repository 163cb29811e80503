#include "calib/adjust/lens_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/calib/adjust/synthetic_capture.h"

namespace lumi {
namespace {

Capture scene_with(const Camera& lens, unsigned seed = 1) {
    SyntheticCaptureOptions scene;
    scene.views = 8;
    scene.points = 250;
    scene.noise_px = 0.4;
    scene.arc_deg = 80;
    scene.arc_radius = 2.2;  // So near that the cloud fills the pictures to their corners.
    scene.seed = seed;
    return synthetic_capture(lens, scene);
}

LensChoice choice_for(const Capture& capture) {
    SilentProgress progress;
    const auto choice =
        select_lens(capture, 0, every_lens_form(), BundleAdjustmentOptions{}, {}, 2, progress);
    EXPECT_TRUE(choice.has_value());
    return choice.value_or(LensChoice{{LensTrial{}}, 0, 0, 0});
}

TEST(LensSelection, TakesWhatTheLensHasAndNoMore) {
    const std::vector<std::pair<Camera, LensForm>> cases{
        {{1000, 800, LensModel::kSimplePinhole, {700, 500, 400}},
         with_principal_point_held(LensModel::kSimplePinhole)},
        {{1000, 800, LensModel::kSimpleRadial, {700, 500, 400, -0.08}},
         with_principal_point_held(LensModel::kSimpleRadial)},
        {{1000, 800, LensModel::kRadial, {700, 500, 400, -0.2, 0.15}},
         with_principal_point_held(LensModel::kRadial)},
        {{1000, 800, LensModel::kSimpleRadial, {700, 530, 380, -0.08}},
         all_free(LensModel::kSimpleRadial)},
        {{1000, 800, LensModel::kPinhole, {700, 730, 500, 400}},
         with_principal_point_held(LensModel::kPinhole)},
        {{1000, 800, LensModel::kOpenCvFisheye, {450, 450, 500, 400, 0.05, -0.02, 0.01, 0}},
         with_principal_point_held(LensModel::kOpenCvFisheye)}};
    for (const auto& [lens, expected] : cases) {
        Capture capture = scene_with(lens);
        // Known beforehand: nothing but the picture's middle, and a focal length that is a bit off.
        capture.cameras[0] = {
            1000, 800, LensModel::kSimplePinhole, {1.02 * lens.parameters[0], 500, 400}};
        const LensChoice choice = choice_for(capture);
        EXPECT_EQ(choice.choice().form, expected) << text_of(expected) << " expected\n"
                                                  << lens_choice_table(choice);
        EXPECT_NEAR(focal_length_px(choice.choice().lens).x(), lens.parameters[0],
                    0.005 * lens.parameters[0])
            << text_of(expected);
    }
}

TEST(LensSelection, ABendThatDiffersFromViewToViewIsNobodysLens) {
    // Every photograph is bent in its own way, as by a rolling shutter: neighbouring pixels err
    // alike, and least squares with parameters to spare follow some of it.
    Capture capture = scene_with({1000, 800, LensModel::kSimplePinhole, {700, 500, 400}});
    std::mt19937 random(3);
    std::normal_distribution<double> gaussian(0.0, 1.0);
    std::vector<Eigen::Vector3d> bend_of_view;
    for (std::size_t view = 0; view < capture.views.size(); ++view) {
        bend_of_view.emplace_back(gaussian(random), gaussian(random), gaussian(random));
    }
    for (ScenePoint& point : capture.points) {
        for (Observation& seen : point.track) {
            const Eigen::Vector3d& bend = bend_of_view[static_cast<std::size_t>(seen.view_index)];
            const Eigen::Vector2d at = (seen.pixel - Eigen::Vector2d(500, 400)) / 500;
            seen.pixel += 0.5 * (bend[0] * at.squaredNorm() * at +
                                 bend[1] * Eigen::Vector2d(at.x() * at.y(), at.y() * at.y()) +
                                 bend[2] * Eigen::Vector2d(at.x() * at.x(), at.x() * at.y()));
        }
    }
    const LensChoice choice = choice_for(capture);
    EXPECT_GT(free_parameters(choice.trials[choice.least_bic].form),
              free_parameters(choice.choice().form))
        << lens_choice_table(choice);
}

TEST(LensSelection, KeepsAGivenLensThatIsRightAndRefinesOneThatIsNot) {
    const Camera lens{1000, 800, LensModel::kSimpleRadial, {700, 500, 400, -0.08}};
    Capture capture = scene_with(lens);
    SilentProgress progress;
    const std::vector<LensForm> forms = forms_of_given_lens(lens.model);
    const auto right = select_lens(capture, 0, forms, {}, {}, 1, progress);
    ASSERT_TRUE(right.has_value());
    EXPECT_EQ(right->choice().form, all_held(lens.model)) << lens_choice_table(*right);
    EXPECT_EQ(right->choice().lens, lens);

    capture.cameras[0].parameters = {720, 500, 400, 0};
    const auto wrong = select_lens(capture, 0, forms, {}, {}, 1, progress);
    ASSERT_TRUE(wrong.has_value());
    EXPECT_EQ(wrong->choice().form, with_principal_point_held(lens.model))
        << lens_choice_table(*wrong);
}

TEST(LensSelection, GoesByBicWhereNoViewCanBePredicted) {
    Capture capture = scene_with({1000, 800, LensModel::kSimplePinhole, {700, 500, 400}});
    for (ScenePoint& point : capture.points) point.track.resize(2);
    const LensChoice choice = choice_for(capture);
    EXPECT_EQ(choice.chosen, choice.least_bic) << lens_choice_table(choice);
    EXPECT_NE(lens_choice_table(choice).find("no view sees what two others see"),
              std::string::npos);
}

TEST(LensSelection, TellsNothingOfAFewViews) {
    SyntheticCaptureOptions scene;
    scene.views = 4;
    const Capture capture =
        synthetic_capture({1000, 800, LensModel::kSimplePinhole, {700, 500, 400}}, scene);
    SilentProgress progress;
    EXPECT_FALSE(select_lens(capture, 0, every_lens_form(), {}, {}, 1, progress).has_value());
}

TEST(LensSelection, IsTheSameForAnyNumberOfThreads) {
    const Capture capture =
        scene_with({1000, 800, LensModel::kSimpleRadial, {700, 500, 400, -0.08}});
    SilentProgress progress;
    const std::vector<LensForm> forms{with_principal_point_held(LensModel::kSimplePinhole),
                                      with_principal_point_held(LensModel::kSimpleRadial)};
    const auto one = select_lens(capture, 0, forms, {}, {}, 1, progress);
    const auto two = select_lens(capture, 0, forms, {}, {}, 3, progress);
    ASSERT_TRUE(one && two);
    EXPECT_EQ(lens_choice_table(*one), lens_choice_table(*two));
    EXPECT_EQ(one->choice().lens, two->choice().lens);
    EXPECT_EQ(one->choice().held_out_rms_px, two->choice().held_out_rms_px);
}

TEST(LensSelection, FollowsOneOfTwoCameras) {
    Capture capture = scene_with({1000, 800, LensModel::kSimpleRadial, {700, 500, 400, -0.1}});
    // The same views again, through a second lens without distortion.
    const Camera second{1000, 800, LensModel::kSimplePinhole, {900, 500, 400}};
    capture.cameras.push_back(second);
    std::mt19937 random(7);
    std::normal_distribution<double> noise_px(0.0, 0.4);
    for (std::size_t view = 1; view < capture.views.size(); view += 2) {
        capture.views[view].camera_index = 1;
    }
    for (ScenePoint& point : capture.points) {
        for (Observation& seen : point.track) {
            const View& view = capture.views[static_cast<std::size_t>(seen.view_index)];
            if (view.camera_index == 0) continue;
            seen.pixel = project(second, view.cam_from_world * point.position_in_world).value() +
                         Eigen::Vector2d(noise_px(random), noise_px(random));
        }
    }
    SilentProgress progress;
    LensSelectionOptions options;
    options.min_views = 4;
    const auto first = select_lens(capture, 0, every_lens_form(), {}, options, 2, progress);
    ASSERT_TRUE(first.has_value());
    EXPECT_EQ(first->choice().form, with_principal_point_held(LensModel::kSimpleRadial))
        << lens_choice_table(*first);
    EXPECT_EQ(first->choice().folds.size(), 4u);
    const auto other = select_lens(capture, 1, every_lens_form(), {}, options, 2, progress);
    ASSERT_TRUE(other.has_value());
    EXPECT_EQ(other->choice().form, with_principal_point_held(LensModel::kSimplePinhole))
        << lens_choice_table(*other);
}

TEST(RepresentativePart, CoversEveryViewWithAboutAsManyObservationsAsAsked) {
    const Capture capture = scene_with({1000, 800, LensModel::kSimplePinhole, {700, 500, 400}});
    const Capture part = representative_part(capture, 500);
    std::size_t observations = 0;
    std::set<int> views;
    for (const ScenePoint& point : part.points) {
        observations += point.track.size();
        for (const Observation& seen : point.track) views.insert(seen.view_index);
    }
    EXPECT_GE(observations, 500u);
    EXPECT_LT(observations, 520u);
    EXPECT_EQ(views.size(), capture.views.size());
    EXPECT_EQ(representative_part(capture, 1000000).points.size(), capture.points.size());
}

}  // namespace
}  // namespace lumi
