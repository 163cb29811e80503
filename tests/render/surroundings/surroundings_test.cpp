#include "render/surroundings/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "render/frame/frame.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

const Camera kOutlookCamera = pinhole_camera(80, 60, 70);
const Eigen::Vector3d kCentre(0, 0, 4);

ColorGrid around(const Lumigraph& lumigraph, const Eye& eye) {
    PictureCells cells(eye.camera);
    cells.mark_all();
    return surrounding_colors(lumigraph, small_photographs(lumigraph), eye, cells);
}

/// The largest difference of a colour between two grids.
float difference(const ColorGrid& a, const ColorGrid& b) {
    float largest = 0;
    for (std::size_t i = 0; i < a.colors.size(); ++i)
        largest = std::max(largest, (a.colors[i] - b.colors[i]).cwiseAbs().maxCoeff());
    return largest;
}

TEST(ColorGrid, IsLinearOnEitherSideOfADiagonal) {
    PictureCells cells(pinhole_camera(240, 240, 100));
    ColorGrid grid{cells, std::vector<Eigen::Vector3f>(25 * 25, Eigen::Vector3f::Zero())};
    ASSERT_EQ(cells.cell_px(), 10.0);
    grid.colors[1] = {100, 0, 0};
    grid.colors[25] = {0, 100, 0};
    grid.colors[26] = {100, 100, 200};
    EXPECT_TRUE(grid.at({0, 0}).isApprox(Eigen::Vector3f(0, 0, 0)));
    EXPECT_TRUE(grid.at({10, 10}).isApprox(Eigen::Vector3f(100, 100, 200)));
    EXPECT_TRUE(grid.at({8, 2}).isApprox(Eigen::Vector3f(80, 20, 40)));
    EXPECT_TRUE(grid.at({2, 8}).isApprox(Eigen::Vector3f(20, 80, 40)));
    EXPECT_TRUE(grid.at({5, 5}).isApprox(Eigen::Vector3f(50, 50, 100)));
}

TEST(Surroundings, OfPhotographsOfOneColourHaveThatColourEverywhere) {
    Lumigraph lumigraph = card_before_wall();
    for (LumigraphView& view : lumigraph.views)
        view.photograph =
            ColorImage(view.camera.width_px, view.camera.height_px, Rgb8{30, 90, 200});
    for (const Eigen::Vector3d& target :
         {kCentre, Eigen::Vector3d(9, 0, 1), Eigen::Vector3d(0, 0, -9)}) {
        const ColorGrid grid = around(lumigraph, eye_at({0.2, 0.1, 0}, target, kOutlookCamera));
        for (const Eigen::Vector3f& color : grid.colors)
            EXPECT_LT((color - Eigen::Vector3f(30, 90, 200)).cwiseAbs().maxCoeff(), 0.01F);
    }
}

TEST(Surroundings, AtACameraAreItsPhotographBlurred) {
    const Lumigraph lumigraph = card_before_wall();
    const LumigraphView& view = lumigraph.views[0];
    // So large that its cells are not the smallest that there are.
    Camera camera = view.camera;
    camera.width_px *= 4;
    camera.height_px *= 4;
    for (double& parameter : camera.parameters) parameter *= 4;
    const ColorGrid grid = around(lumigraph, {camera, view.cam_from_world});
    const ColorImage small = small_photographs(lumigraph).of_views[0];
    double sum = 0;
    for (int y = 0; y < small.height(); ++y) {
        for (int x = 0; x < small.width(); ++x) {
            const Eigen::Vector2d pixel((x + 0.5) * camera.width_px / small.width(),
                                        (y + 0.5) * camera.height_px / small.height());
            const Rgb8& color = small(x, y);
            sum += static_cast<double>(
                (grid.at(pixel) - Eigen::Vector3f(color.r, color.g, color.b)).cwiseAbs().mean());
        }
    }
    EXPECT_LT(sum / (small.width() * small.height()), 12.0);
}

TEST(Surroundings, GoOnWithTheColourAtTheBorder) {
    // Red on the left half, blue on the right one.
    Lumigraph lumigraph = card_before_wall();
    for (LumigraphView& view : lumigraph.views)
        for (int y = 0; y < view.photograph.height(); ++y)
            for (int x = 0; x < view.photograph.width(); ++x)
                view.photograph(x, y) =
                    2 * x < view.photograph.width() ? Rgb8{200, 0, 0} : Rgb8{0, 0, 200};
    const Camera wide = pinhole_camera(80, 60, 25);
    const ColorGrid grid = around(lumigraph, eye_at({0, 0, 0}, kCentre, wide));
    EXPECT_GT(grid.at({1, 30}).x(), 190.0F);
    EXPECT_GT(grid.at({79, 30}).z(), 190.0F);
}

TEST(Surroundings, OfMarkedCellsAreThoseOfTheWhole) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.2, 0.1, 0}, kCentre, kOutlookCamera);
    const ColorGrid whole = around(lumigraph, eye);
    PictureCells cells(eye.camera);
    cells.mark(3, 2);
    const ColorGrid part = surrounding_colors(lumigraph, small_photographs(lumigraph), eye, cells);
    for (int row = 0; row <= cells.rows(); ++row) {
        for (int column = 0; column <= cells.columns(); ++column) {
            const bool is_wanted = (column == 3 || column == 4) && (row == 2 || row == 3);
            EXPECT_EQ(part.corner(column, row),
                      is_wanted ? whole.corner(column, row) : Eigen::Vector3f(0, 0, 0));
        }
    }
}

TEST(Surroundings, AreSteadyInTheEye) {
    const Lumigraph lumigraph = card_before_wall();
    const Eigen::Vector3d way(1e-4, 2e-4, 1e-4);
    for (double x = -3; x <= 3; x += 0.25) {
        const Eigen::Vector3d place(x, 0.3, -0.5);
        const Eye eye = eye_at(place, kCentre, kOutlookCamera);
        const Eye moved{
            kOutlookCamera,
            {eye.cam_from_world.rotation, -(eye.cam_from_world.rotation * (place + way))}};
        EXPECT_LT(difference(around(lumigraph, eye), around(lumigraph, moved)), 0.5F) << x;
    }
}

/// More views than count at once, in a row before the wall.
Lumigraph long_row() {
    std::vector<Eye> cameras;
    for (int i = 0; i < 30; ++i)
        cameras.push_back(eye_at({0.2 * i - 3, 0.05 * (i % 2), 0}, {0.2 * i - 3, 0, 4},
                                 pinhole_camera(32, 24, 30)));
    return photographed(AnalyticScene::kCardBeforeWall, cameras);
}

// Wherever one of the twelve nearest views gives way to the next, that one has the other colour.
TEST(Surroundings, OfManyViewsAreSteadyAsViewsComeAndGo) {
    Lumigraph lumigraph = long_row();
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        ColorImage& photograph = lumigraph.views[i].photograph;
        photograph = ColorImage(photograph.width(), photograph.height(),
                                i % 24 < 12 ? Rgb8{0, 0, 0} : Rgb8{255, 255, 255});
    }
    constexpr double kStep = 1e-3;
    ColorGrid before = around(lumigraph, eye_at({-1, 0, 0}, {-1, 0, 4}, kOutlookCamera));
    for (double x = -1 + kStep; x <= 1; x += kStep) {
        ColorGrid now = around(lumigraph, eye_at({x, 0, 0}, {x, 0, 4}, kOutlookCamera));
        ASSERT_LT(difference(before, now), 1.0F) << x;
        before = std::move(now);
    }
}

TEST(Surroundings, OfManyViewsAreThoseOfTheNearest) {
    Lumigraph lumigraph = long_row();
    const Eye eye = eye_at({-2, 0, 0}, {-2, 0, 4}, kOutlookCamera);
    const ColorGrid grid = around(lumigraph, eye);
    for (std::size_t far = 20; far < lumigraph.views.size(); ++far) {
        ColorImage& photograph = lumigraph.views[far].photograph;
        photograph = ColorImage(photograph.width(), photograph.height(), Rgb8{255, 0, 255});
    }
    EXPECT_LT(difference(grid, around(lumigraph, eye)), 0.01F);
}

TEST(Surroundings, AreDrawnOnlyBehindPicturesOfModesThatGuess) {
    EXPECT_TRUE(are_surroundings_drawn({}));
    EXPECT_FALSE(are_surroundings_drawn({.guess_surroundings = false}));
    EXPECT_FALSE(are_surroundings_drawn({.fade_beyond_capture = true}));
    EXPECT_FALSE(are_surroundings_drawn({.debug_picture = DebugPicture::kDepth}));
    EXPECT_FALSE(are_surroundings_drawn({.mode = RenderMode::kPaper2001}));
}

}  // namespace
}  // namespace lumi
