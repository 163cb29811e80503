#include "pipeline/evaluate/asked_efforts.h"

#include <gtest/gtest.h>

#include "calib/work/error.h"
#include "pipeline/evaluate/depth_effort.h"
#include "tests/calib/noted_progress.h"
#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

DrawingOptions all_given() {
    DrawingOptions wanted;
    wanted.noisy_depth_error_px = 0.4;
    wanted.occlusion_tolerance_px = 7;
    wanted.depth_views = kLeastDepthViews;
    wanted.depth_block_px = 1.5;
    wanted.fill_holes = true;
    wanted.check_guesses = true;
    wanted.triangle_error_px = 3;
    wanted.draw_thin = true;
    return wanted;
}

TEST(AskedEfforts, AreThoseThatWereGivenWithoutAskingAnyone) {
    Studio studio = before_a_board(18, 0.1);
    studio.find_points();
    const Lumigraph lumigraph = with_camera_mesh(studio);
    NotedProgress progress;
    const DepthMeshEffort of_meshes =
        asked_depth_mesh_effort(lumigraph, studio.capture, {}, all_given(), progress);
    const DrawingEfforts efforts =
        asked_drawing_efforts(lumigraph, studio.capture, {}, all_given(), progress);
    EXPECT_EQ(of_meshes.noisy_error_px, 0.4);
    DrawingChoices drawing;
    choose(efforts, drawing);
    EXPECT_EQ(drawing, (DrawingChoices{.occlusion_tolerance_px = 7,
                                       .depth_views = kLeastDepthViews,
                                       .depth_block_px = 1.5,
                                       .fills_holes = true,
                                       .checks_guesses = true,
                                       .triangle_error_px = 3,
                                       .draws_thin = true}));
    EXPECT_EQ(efforts.occlusion.pictures + efforts.depth.pictures + efforts.triangles.pictures, 0);
    EXPECT_TRUE(progress.notes.empty());
}

TEST(AskedEfforts, AreAskedWithWhatWasChosenBefore) {
    Studio studio = from_all_around(kBodiesInTheWay, 20);
    studio.find_points();
    const Lumigraph lumigraph = with_camera_mesh(studio);
    NotedProgress progress;
    DrawingOptions wanted = all_given();
    wanted.occlusion_tolerance_px = 60;
    wanted.check_guesses.reset();
    const DepthEffort depth =
        asked_drawing_efforts(lumigraph, studio.capture, {}, wanted, progress).depth;
    KeptBackPhotographs photographs(lumigraph, studio.capture, {}, progress);
    DrawingChoices tolerant = lumigraph.drawing;
    tolerant.occlusion_tolerance_px = 60;
    const double tolerant_db = sufficient_depth_effort(photographs, tolerant).fewer_views_lose_db;
    const double strict_db =
        sufficient_depth_effort(photographs, lumigraph.drawing).fewer_views_lose_db;
    EXPECT_EQ(depth.fewer_views_lose_db, tolerant_db);
    EXPECT_NE(depth.fewer_views_lose_db, strict_db);
    EXPECT_EQ(depth.views, kLeastDepthViews) << "as was given";
    EXPECT_EQ(progress.notes.size(), 1U);
}

TEST(AskedEfforts, StopOnRequest) {
    Studio studio = before_a_board(18, 0.1);
    studio.find_points();
    const Lumigraph lumigraph = with_camera_mesh(studio);
    NotedProgress progress;
    progress.interrupt();
    EXPECT_THROW((void)asked_drawing_efforts(lumigraph, studio.capture, {}, {}, progress), Error);
    EXPECT_TRUE(progress.notes.empty());
}

}  // namespace
}  // namespace lumi
