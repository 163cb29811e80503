#include "meshing/depth/depth_stage.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/formatted.h"
#include "calib/work/median.h"
#include "tests/calib/scratch_folder.h"
#include "tests/meshing/depth/raycast_scene.h"

namespace lumi {
namespace {

/// A board before a slanted wall, from five cameras in a cross.
KnownDepthScene board_and_wall() {
    const auto board = [](const Eigen::Vector3d& p) {
        return std::abs(p.x()) < 0.3 && std::abs(p.y()) < 0.25;
    };
    return known_depth_scene(
        {{{0, 0, 3}, {0.2, 0.1, 1}, [](const auto&) { return true; }, noise_texture(0.04, 5)},
         {{0, 0, 1.8}, {0, 0, 1}, board, noise_texture(0.025, 8)}},
        cross_of_centres(0.2), {});
}

/// Exact points of the first view's pixels, on a coarse grid, seen by the views of `seen_by`.
void add_points(const KnownDepthScene& known, const std::vector<int>& seen_by, Capture& capture) {
    const DepthView& view = known.scene.views[0];
    for (int y = 10; y < 180; y += 20) {
        for (int x = 10; x < 240; x += 20) {
            const double depth = 1.0 / static_cast<double>(known.inverse_depths[0](x, y));
            ScenePoint point;
            point.position_in_world =
                inverse(view.cam_from_world) *
                (depth * unproject(view.camera, Eigen::Vector2d(x + 0.5, y + 0.5)));
            for (const int i : seen_by) point.track.push_back({i, {x + 0.5, y + 0.5}});
            capture.points.push_back(point);
        }
    }
}

DepthResult depth_of(const PosedPhotographs& photographs, const std::vector<int>& views,
                     const DepthOptions& options = {}, int threads = 2) {
    SilentProgress progress;
    return estimate_depth(photographs, views, options, threads, progress);
}

void expect_same(const DepthResult& a, const DepthResult& b) {
    ASSERT_EQ(a.depth_maps.size(), b.depth_maps.size());
    for (std::size_t i = 0; i < a.depth_maps.size(); ++i) {
        EXPECT_EQ(a.depth_maps[i].inverse_depth, b.depth_maps[i].inverse_depth) << i;
        EXPECT_EQ(a.depth_maps[i].confidence, b.depth_maps[i].confidence) << i;
    }
}

TEST(DepthStage, WarnsWhereTheScenePointsContradictWhatAllViewsAgreeOn) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    PosedPhotographs photographs = written(known, folder.path());
    add_points(known, {0, 1, 2, 3, 4}, photographs.capture);
    for (ScenePoint& point : photographs.capture.points) point.position_in_world.z() *= 1.1;
    const DepthResult result = depth_of(photographs, {0, 1, 2, 3, 4});
    EXPECT_THAT(result.warning, testing::StartsWith("depth is doubtful"));
    std::vector<double> residuals_px;
    for (const DepthEvidence& evidence : result.evidence) {
        residuals_px.push_back(evidence.sparse_residual_px);
    }
    const double residual_px = median_of(std::move(residuals_px));
    EXPECT_THAT(result.warning,
                testing::HasSubstr(formatted(" than %.1f px of disparity", residual_px)))
        << residual_px << ": rounded, not cut";
}

TEST(DepthStage, ConfidentPixelsAreRightAndEveryPixelHasADepth) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    for (const bool with_points : {true, false}) {
        PosedPhotographs photographs = written(known, folder.path());
        if (with_points) add_points(known, {0, 1, 2, 3, 4}, photographs.capture);
        const DepthResult result = depth_of(photographs, {0, 1, 2, 3, 4});
        EXPECT_EQ(result.evidence[0].model, "sweep");
        EXPECT_GT(result.evidence[0].confident_share, 0.9);
        EXPECT_LT(result.evidence[0].sparse_residual_px, 0.3);
        EXPECT_EQ(result.warning, "");
        const DepthMap& map = result.depth_maps[0];
        const FloatImage errors = errors_px(map, known.inverse_depths[0], known.scene.views[0]);
        int confident = 0;
        int right = 0;
        for (std::size_t i = 0; i < errors.pixels().size(); ++i) {
            ASSERT_TRUE(std::isfinite(errors.pixels()[i]));
            ASSERT_GE(map.inverse_depth.pixels()[i], 0.0F);
            if (map.confidence.pixels()[i] == 0) continue;
            ++confident;
            if (errors.pixels()[i] <= 1.0F) ++right;
        }
        EXPECT_GT(right, 0.98 * confident);
    }
}

TEST(DepthStage, GivesTheSameBytesForAnyNumberOfThreads) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    const PosedPhotographs photographs = written(known, folder.path());
    const DepthResult one = depth_of(photographs, {0, 1, 2, 3, 4}, {}, 1);
    expect_same(one, depth_of(photographs, {0, 1, 2, 3, 4}, {}, 5));
    expect_same(one, depth_of(photographs, {0, 1, 2, 3, 4}, {.max_memory_mib = 256}, 5));
}

TEST(DepthStage, RefinesToTheSameBytesForAnyNumberOfThreads) {
    const ScratchFolder folder;
    const PosedPhotographs photographs = written(board_and_wall(), folder.path());
    const std::vector<int> views{0, 1, 2, 3, 4};
    const DepthOptions options{.model = "refined_sweep", .max_width_px = 120};
    const DepthResult one = depth_of(photographs, views, options, 1);
    EXPECT_EQ(one.evidence[0].model, "refined_sweep");
    expect_same(one, depth_of(photographs, views, options, 2));
    expect_same(one, depth_of(photographs, views, options, 8));
}

TEST(DepthStage, HeldOutViewsTakeNoPart) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    PosedPhotographs photographs = written(known, folder.path());
    add_points(known, {0, 1, 3}, photographs.capture);
    const DepthResult before = depth_of(photographs, {0, 1, 3, 4});
    // Another picture, another pose and points that rest on it alone must change nothing.
    write_png(photographs.picture_paths[2], ColorImage(240, 180, {255, 0, 0}));
    photographs.capture.views[2].cam_from_world = looking_ahead_from({0.01, 0.02, 0.5});
    ScenePoint point;
    point.position_in_world = {0, 0, 0.3};
    point.track = {{2, {100, 100}}, {1, {100, 100}}};
    photographs.capture.points.push_back(point);
    expect_same(before, depth_of(photographs, {0, 1, 3, 4}));
    std::filesystem::remove(photographs.picture_paths[2]);
    expect_same(before, depth_of(photographs, {0, 1, 3, 4}));
}

TEST(DepthStage, AWallWithoutTextureEndsWithoutConfidence) {
    const ScratchFolder folder;
    const KnownDepthScene known = known_depth_scene({{{0, 0, 2},
                                                      {0, 0, 1},
                                                      [](const auto&) { return true; },
                                                      [](const auto&) { return 128.0; }}},
                                                    cross_of_centres(0.2), {});
    const DepthResult result = depth_of(written(known, folder.path()), {0, 1, 2, 3, 4});
    for (std::size_t i = 0; i < result.depth_maps.size(); ++i) {
        EXPECT_EQ(result.depth_maps[i].confidence, GrayImage(240, 180, 0));
        EXPECT_EQ(result.evidence[i].confident_share, 0.0);
    }
}

TEST(DepthStage, OneViewAloneFallsBackToItsPoints) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    const DepthResult result = depth_of(written(known, folder.path()), {2});
    EXPECT_EQ(result.evidence[0].model, "sparse_fill");
    EXPECT_EQ(result.depth_maps[0].confidence, GrayImage(240, 180, 0));
}

TEST(DepthStage, TakesImportedDepthInsteadOfItsOwn) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    const PosedPhotographs photographs = written(known, folder.path());
    FloatImage depth(240, 180, 5.0F);
    depth(100, 90) = 0.0F;
    for (const View& view : photographs.capture.views) {
        write_float_tiff(folder.path() / (view.name + ".tiff"), depth);
    }
    DepthOptions options;
    options.import_folder = folder.path();
    const DepthResult result = depth_of(photographs, {0, 1}, options);
    EXPECT_EQ(result.evidence[0].model, "imported");
    EXPECT_EQ(result.depth_maps[0].confidence(100, 90), 0);
    EXPECT_NEAR(result.depth_maps[0].inverse_depth(100, 90), 0.2F, 1e-5F) << "filled";
    EXPECT_EQ(result.depth_maps[1].inverse_depth(7, 7), 0.2F);
}

TEST(DepthStage, RefusesImportedDepthThatSaysNothing) {
    const ScratchFolder folder;
    const PosedPhotographs photographs = written(board_and_wall(), folder.path());
    for (const View& view : photographs.capture.views) {
        write_float_tiff(folder.path() / (view.name + ".tiff"), FloatImage(240, 180, 0.0F));
    }
    DepthOptions options;
    options.import_folder = folder.path();
    try {
        (void)depth_of(photographs, {0, 1}, options);
        ADD_FAILURE() << "expected E-DEPTH-EMPTY";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-DEPTH-EMPTY");
    }
}

TEST(DepthStage, WarnsWhereImportedDepthIsInAnotherUnitThanThePoses) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    PosedPhotographs photographs = written(known, folder.path());
    add_points(known, {0, 1}, photographs.capture);
    DepthOptions options;
    options.import_folder = folder.path();
    const auto warning_for = [&](float unit) {
        for (std::size_t i = 0; i < 2; ++i) {
            FloatImage depth = known.inverse_depths[i];
            for (float& value : depth.pixels()) value = unit / value;
            write_float_tiff(folder.path() / (known.scene.views[i].name + ".tiff"), depth);
        }
        return depth_of(photographs, {0, 1}, options).warning;
    };
    EXPECT_EQ(warning_for(1.0F), "");
    EXPECT_THAT(warning_for(1000.0F), testing::HasSubstr(" lies 1000 times as far away"));
    EXPECT_THAT(warning_for(0.25F), testing::HasSubstr(" lies 0.25 times as far away"));
}

TEST(DepthStage, MapsAreNoWiderThanAsked) {
    const ScratchFolder folder;
    const KnownDepthScene known = board_and_wall();
    const DepthResult result =
        depth_of(written(known, folder.path()), {0, 1}, {.model = "sparse", .max_width_px = 100});
    EXPECT_EQ(result.depth_maps[0].inverse_depth.width(), 100);
    EXPECT_EQ(result.depth_maps[0].inverse_depth.height(), 75);
}

TEST(DepthStage, RefusesAPictureOfAnotherSizeThanItsCamera) {
    const ScratchFolder folder;
    const PosedPhotographs photographs = written(board_and_wall(), folder.path());
    write_png(photographs.picture_paths[1], ColorImage(120, 90));
    try {
        (void)depth_of(photographs, {0, 1});
        ADD_FAILURE() << "expected E-DEPTH-PICTURE";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-DEPTH-PICTURE");
    }
}

TEST(DepthOptions, AreRefusedOutsideTheirRange) {
    EXPECT_NO_THROW(validate(DepthOptions{}));
    EXPECT_THROW(validate(DepthOptions{.model = "magic"}), Error);
    EXPECT_THROW(validate(DepthOptions{.max_width_px = 0}), Error);
    EXPECT_THROW(validate(DepthOptions{.max_neighbours = 0}), Error);
    EXPECT_THROW(validate(DepthOptions{.max_memory_mib = 0}), Error);
    const ConfigSection section = ConfigSection::from_text("max_neighbours = 99", "test.toml");
    EXPECT_THROW((void)read_depth_options(section), Error);
}

}  // namespace
}  // namespace lumi
