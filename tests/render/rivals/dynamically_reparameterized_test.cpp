#include "render/rivals/dynamically_reparameterized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calib/capture/nearest_byte.h"
#include "tests/render/analytic_scene.h"
#include "tests/render/frame_difference.h"

namespace lumi {
namespace {

constexpr double kSpacing = 0.2;

/// Five rows of five cameras side by side, all looking along z.
Lumigraph wall_of_cameras(AnalyticScene scene = AnalyticScene::kCardBeforeWall,
                          double focal_px = 30) {
    std::vector<Eye> cameras;
    for (int row = -2; row <= 2; ++row) {
        for (int column = -2; column <= 2; ++column) {
            const Eigen::Vector3d place(kSpacing * column, kSpacing * row, 0);
            cameras.push_back(
                eye_at(place, place + Eigen::Vector3d::UnitZ(), pinhole_camera(64, 48, focal_px)));
        }
    }
    return photographed(scene, cameras);
}

/// The camera of row and column is all of one level.
void paint(Lumigraph& lumigraph, int row, int column, unsigned char level) {
    ColorImage& photograph = lumigraph.views[static_cast<std::size_t>(5 * row + column)].photograph;
    std::fill(photograph.pixels().begin(), photograph.pixels().end(), Rgb8{level, level, level});
}

/// All photographs of one level, but the one in the middle.
Lumigraph all_of_one_level(unsigned char level, unsigned char of_middle) {
    Lumigraph lumigraph = wall_of_cameras();
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column) paint(lumigraph, row, column, level);
    paint(lumigraph, 2, 2, of_middle);
    return lumigraph;
}

TEST(DynamicallyReparameterized, ACameraWeighsTheLessTheFartherTheRayPassesIt) {
    const Lumigraph lumigraph = all_of_one_level(0, 200);
    // Through the middle of the picture, from the camera in the middle: that weighs 1, its four
    // neighbours 1 - 0.2 / 0.25, and all others are farther than the radius.
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 1}, pinhole_camera(33, 33, 30));
    const Frame frame = draw_dynamically_reparameterized(
        lumigraph, eye, {.diameter = 0.5, .focal_plane = {.depth = 6}});
    EXPECT_NEAR(frame.color(16, 16).g, 200 / (1 + 4 * 0.2), 1);
    EXPECT_EQ(frame.coverage(16, 16), 255);
}

TEST(DynamicallyReparameterized, BlendsAsMuchAsOneWholeCameraWhereCamerasAreSparse) {
    const Lumigraph lumigraph = all_of_one_level(0, 200);
    // The ray passes cameras of the middle row at 0.05, 0.15, 0.25 and others of the rows beside it
    // at 0.206: with a radius of 0.2 those of the first two sum to 1, linearly between them.
    const Eye eye = eye_at({0.05, 0, 0}, {0.05, 0, 1}, pinhole_camera(33, 33, 30));
    const Frame frame = draw_dynamically_reparameterized(
        lumigraph, eye, {.diameter = 1e-6, .focal_plane = {.depth = 6}});
    EXPECT_NEAR(frame.color(16, 16).g, 200 * (1 - 0.05 / 0.2), 1);
}

/// Of a channel, from a pixel to the next in its row or column.
int largest_step(const ColorImage& picture) {
    int largest = 0;
    for (int y = 1; y < picture.height(); ++y)
        for (int x = 1; x < picture.width(); ++x)
            for (const Rgb8& before : {picture(x - 1, y), picture(x, y - 1)})
                largest = std::max(largest, std::abs(picture(x, y).g - before.g));
    return largest;
}

TEST(DynamicallyReparameterized, NothingJumpsWhereAPhotographEnds) {
    // On a plane so near that the borders of all photographs but the nearest run through the frame.
    // Each fades within 8 pixels, in which something black may give way to something white.
    Lumigraph lumigraph = wall_of_cameras(AnalyticScene::kCardBeforeWall, 60);
    for (int row = 0; row < 5; ++row)
        for (int column = 0; column < 5; ++column)
            paint(lumigraph, row, column, (3 * row + column) % 5 < 2 ? 255 : 0);
    for (const Eigen::Vector3d& place :
         {Eigen::Vector3d(0.07, 0.03, 0), Eigen::Vector3d(-0.11, 0.09, 0.1)}) {
        const Eye eye = eye_at(place, place + Eigen::Vector3d::UnitZ(), pinhole_camera(64, 48, 60));
        for (const double depth : {0.7, 1.2}) {
            const Frame frame = draw_dynamically_reparameterized(
                lumigraph, eye, {.diameter = 1e-6, .focal_plane = {.depth = depth}});
            EXPECT_LT(largest_step(frame.color), 2 * 255 / 8) << depth;
        }
    }
}

/// Each pixel the mean of so many along both sides.
ColorImage averaged(const ColorImage& fine, int times) {
    ColorImage coarse(fine.width() / times, fine.height() / times);
    for (int y = 0; y < coarse.height(); ++y) {
        for (int x = 0; x < coarse.width(); ++x) {
            Eigen::Vector3d sum = Eigen::Vector3d::Zero();
            for (int v = 0; v < times; ++v)
                for (int u = 0; u < times; ++u) {
                    const Rgb8& pixel = fine(times * x + u, times * y + v);
                    sum += Eigen::Vector3d(pixel.r, pixel.g, pixel.b);
                }
            sum /= times * times;
            coarse(x, y) = {nearest_byte(sum.x()), nearest_byte(sum.y()), nearest_byte(sum.z())};
        }
    }
    return coarse;
}

TEST(DynamicallyReparameterized, ASmallFrameIsTheLargeOneAveraged) {
    const Lumigraph lumigraph = wall_of_cameras(AnalyticScene::kPrintedCard, 120);
    const auto drawn = [&](int width_px, int height_px, double focal_px) {
        const Eye eye =
            eye_at({0.07, 0.03, 0}, {0.07, 0.03, 1}, pinhole_camera(width_px, height_px, focal_px));
        return draw_dynamically_reparameterized(lumigraph, eye,
                                                {.diameter = 0.6, .focal_plane = {.depth = 3}})
            .color;
    };
    const ColorImage small = drawn(16, 12, 30);
    EXPECT_LT(difference_between(small, averaged(drawn(64, 48, 120), 4)).mean, 6);
}

TEST(DynamicallyReparameterized, CamerasThatAreAllAsFarAreBlendedAlike) {
    Lumigraph lumigraph = all_of_one_level(100, 100);
    const Eye in_middle_of_four = eye_at({0.1, 0.1, 0}, {0.1, 0.1, 1}, pinhole_camera(33, 33, 30));
    const Frame frame = draw_dynamically_reparameterized(
        lumigraph, in_middle_of_four, {.diameter = 1e-6, .focal_plane = {.depth = 6}});
    EXPECT_EQ(frame.color(16, 16).g, 100);
    EXPECT_EQ(frame.coverage(16, 16), 255);
    for (LumigraphView& view : lumigraph.views)
        view.cam_from_world = lumigraph.views[12].cam_from_world;
    const Frame at_one_place = draw_dynamically_reparameterized(
        lumigraph, eye_at({0, 0, 0}, {0, 0, 1}, pinhole_camera(33, 33, 30)),
        {.diameter = usual_aperture_diameter(lumigraph), .focal_plane = {.depth = 6}});
    EXPECT_EQ(at_one_place.color(16, 16).g, 100);
}

double error_of_middle(const Lumigraph& lumigraph, const SyntheticAperture& aperture,
                       const ColorImage& truth, const Eye& eye) {
    const Frame frame = draw_dynamically_reparameterized(lumigraph, eye, aperture);
    double error = 0;
    for (int y = 22; y < 26; ++y)
        for (int x = 30; x < 34; ++x) error += std::abs(frame.color(x, y).g - truth(x, y).g);
    return error / 16;
}

TEST(DynamicallyReparameterized, WhatLiesOnTheFocalPlaneIsSharp) {
    // The print on the card, at z = 3, which fills the middle of the picture, is 8 pixels fine.
    const Lumigraph lumigraph = wall_of_cameras(AnalyticScene::kPrintedCard, 120);
    const Eye eye = eye_at({0.07, 0.03, 0}, {0.07, 0.03, 1}, pinhole_camera(64, 48, 120));
    const ColorImage truth = ideal_photograph(AnalyticScene::kPrintedCard, eye);
    const auto error = [&](double depth) {
        return error_of_middle(lumigraph, {.diameter = 0.6, .focal_plane = {.depth = depth}}, truth,
                               eye);
    };
    EXPECT_LT(error(3), 12);
    EXPECT_GT(error(6), 3 * error(3));
    EXPECT_GT(error(2), 3 * error(3));
}

TEST(DynamicallyReparameterized, AWideApertureSeesThroughWhatStandsBeforeItsPlane) {
    std::vector<Eye> cameras;
    for (int column = -10; column <= 10; ++column) {
        const Eigen::Vector3d place(0.1 * column, 0, 0);
        cameras.push_back(
            eye_at(place, place + Eigen::Vector3d::UnitZ(), pinhole_camera(192, 48, 240)));
    }
    const Lumigraph lumigraph = photographed(AnalyticScene::kBarBeforeWall, cameras);
    const Eye eye = eye_at({0, 0, 0}, {0, 0, 1}, pinhole_camera(64, 48, 240));
    // The wall without its bar, as a camera beside it sees the same place.
    const Eigen::Vector2d behind_bar(32.5, 24.5);
    const Eigen::Vector3d on_wall = 6 * unproject(eye.camera, behind_bar);
    const Eye beside = eye_at({0.3, 0, 0}, {0.3, 0, 1}, pinhole_camera(192, 48, 240));
    const auto pixel = project(beside.camera, beside.cam_from_world * on_wall);
    ASSERT_TRUE(pixel.has_value());
    const ColorImage seen_beside = ideal_photograph(AnalyticScene::kBarBeforeWall, beside);
    const int wall = seen_beside(static_cast<int>(pixel->x()), static_cast<int>(pixel->y())).r;
    const auto off = [&](double diameter) {
        const Frame frame = draw_dynamically_reparameterized(
            lumigraph, eye, {.diameter = diameter, .focal_plane = {.depth = 6}});
        return std::abs(frame.color(32, 24).r - wall);
    };
    EXPECT_GT(off(0.1), 20);
    EXPECT_LT(off(2), 0.3 * off(0.1));
}

TEST(DynamicallyReparameterized, CamerasBeyondThePointHaveNoWeight) {
    Lumigraph lumigraph = ball_in_sky();
    const LumigraphView& view = lumigraph.views[0];
    const Eigen::Vector3d towards_ball = -centre_in_world(view.cam_from_world).normalized();
    for (LumigraphView& other : lumigraph.views)
        if (optical_axis_in_world(other.cam_from_world).dot(towards_ball) < 0)
            std::fill(other.photograph.pixels().begin(), other.photograph.pixels().end(),
                      Rgb8{255, 0, 255});
    const Eye eye{view.camera, view.cam_from_world};
    const Frame frame = draw_dynamically_reparameterized(lumigraph, eye, {.diameter = 0.1});
    const int middle_x = view.camera.width_px / 2;
    const int middle_y = view.camera.height_px / 2;
    const ColorImage truth = ideal_photograph(AnalyticScene::kBallInSky, eye);
    EXPECT_NEAR(frame.color(middle_x, middle_y).g, truth(middle_x, middle_y).g, 40);
}

TEST(DynamicallyReparameterized, IsTheSameByAnyNumberOfThreads) {
    const Lumigraph lumigraph = wall_of_cameras();
    const Eye eye = eye_at({0.07, 0.03, 0}, {0, 0, 3}, pinhole_camera(64, 48, 30));
    const Frame one =
        draw_dynamically_reparameterized(lumigraph, eye, {.diameter = 0.6, .threads = 1});
    const Frame three =
        draw_dynamically_reparameterized(lumigraph, eye, {.diameter = 0.6, .threads = 3});
    EXPECT_EQ(one.color.pixels(), three.color.pixels());
}

TEST(DynamicallyReparameterized, TheUsualApertureIsFourSpacingsWide) {
    EXPECT_NEAR(usual_aperture_diameter(wall_of_cameras()), 4 * kSpacing, 1e-9);
    Lumigraph alone = wall_of_cameras();
    alone.views.resize(1);
    EXPECT_EQ(usual_aperture_diameter(alone), 0);
}

TEST(DynamicallyReparameterized, TheUsualApertureIsWiderThanWhereCamerasAreSparse) {
    const Lumigraph lumigraph = wall_of_cameras(AnalyticScene::kPrintedCard, 120);
    const Eye eye = eye_at({0.07, 0.03, 0}, {0.07, 0.03, 1}, pinhole_camera(64, 48, 120));
    const auto drawn = [&](double diameter) {
        return draw_dynamically_reparameterized(lumigraph, eye,
                                                {.diameter = diameter, .focal_plane = {.depth = 6}})
            .color;
    };
    const ColorImage usual = drawn(usual_aperture_diameter(lumigraph));
    EXPECT_GT(difference_between(usual, drawn(1e-6)).share_beyond_two, 0.1);
}

}  // namespace
}  // namespace lumi
