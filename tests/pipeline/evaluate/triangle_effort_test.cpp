#include "pipeline/evaluate/triangle_effort.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "pipeline/synth/hand_held_path.h"
#include "tests/pipeline/studio.h"

namespace lumi {
namespace {

TriangleEffort effort_of(const Studio& studio, double given_error_px = 0) {
    SilentProgress progress;
    const Lumigraph lumigraph = with_camera_mesh(studio);
    KeptBackPhotographs photographs(lumigraph, studio.capture, {}, progress);
    return sufficient_triangle_effort(photographs, lumigraph.drawing, given_error_px);
}

TEST(TriangleEffort, IsTheLeastWherePicturesShowTheSameEverywhere) {
    Studio studio = before_a_board(18, 0.1);
    studio.find_points();
    for (LumigraphView& view : studio.lumigraph.views)
        for (Rgb8& pixel : view.photograph.pixels()) pixel = {120, 130, 140};
    const TriangleEffort effort = effort_of(studio);
    EXPECT_EQ(effort.error_px, 4.0);
    EXPECT_EQ(effort.pictures, 9);
    EXPECT_NEAR(effort.loses_db, 0, 0.05);
    EXPECT_GT(effort.triangles, 0);
    EXPECT_EQ(effort.thin_gains_db, 0);
    EXPECT_FALSE(effort.draws_thin);
}

/// A lattice of bars, two pixels wide, far before a board.
std::string bars_before_a_board() {
    std::string scene = kFlatBoard;
    scene += R"(
[[material]]
name = "paint"
pattern = "stone"
colors = ["#103018", "#204828", "#081008"]
feature_size = 0.1
[[body]]
name = "bars"
material = "paint"
solids = [
)";
    for (int i = -6; i <= 6; ++i)
        scene += "{ shape = \"box\", at = [" + std::to_string(0.22 * i) +
                 ", 0, 1.7], size = [0.02, 3, 0.02] },\n";
    return scene + "]\n";
}

TEST(TriangleEffort, DrawsWhatIsThinWhereThatStandsApart) {
    const std::string scene = bars_before_a_board();
    Studio studio(scene.c_str());
    constexpr int kCount = 24;
    for (int i = 0; i < kCount; ++i) {
        const double radius = 0.8 * std::sqrt((i + 0.5) / kCount);
        const Eigen::Vector3d place(radius * std::cos(2.4 * i), radius * std::sin(2.4 * i), 2.6);
        studio.photograph_from(looking_at(place, place - Eigen::Vector3d(0, 1e-3, 1)));
    }
    studio.find_points();
    const TriangleEffort effort = effort_of(studio);
    EXPECT_GT(effort.thin_gains_db, 0.1);
    EXPECT_GT(effort.thin_gains_db, effort.thin_standard_error_db);
    EXPECT_TRUE(effort.draws_thin);
    // With triangles that are given, among those asked or not.
    EXPECT_EQ(effort_of(studio, kTriangleError_px).thin_gains_db, effort.thin_gains_db);
    EXPECT_GT(effort_of(studio, 3.0).thin_gains_db, effort.thin_gains_db) << "they miss more bars";
}

TEST(TriangleEffort, IsGreaterWhereBodiesHideOneAnother) {
    Studio studio = from_all_around(kBodiesInTheWay, 40);
    studio.find_points();
    const TriangleEffort effort = effort_of(studio);
    EXPECT_LT(effort.error_px, 2.0);
    EXPECT_LE(effort.loses_db, 0.1);
}

TEST(TriangleEffort, IsAsUsualForFewerThanEightViewsUnasked) {
    Studio studio = before_a_board(7, 0.1);
    studio.find_points();
    const TriangleEffort effort = effort_of(studio);
    EXPECT_EQ(effort.error_px, kTriangleError_px);
    EXPECT_EQ(effort.pictures, 0);
}

}  // namespace
}  // namespace lumi
