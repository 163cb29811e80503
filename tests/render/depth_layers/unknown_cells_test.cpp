#include "render/depth_layers/unknown_cells.h"

#include <gtest/gtest.h>

#include "render/depth_search/searched_views.h"
#include "render/reference/agreed_depth.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

const Camera kLookingCamera = pinhole_camera(240, 180, 210);
constexpr double kAnyDepth = 1e9;

PictureCells marked_for(const Lumigraph& lumigraph, const Eye& eye) {
    const SearchedViews views = searched_views(lumigraph);
    PictureCells cells(eye.camera);
    mark_where_depth_may_be_unknown(lumigraph, views.depths,
                                    depth_view_sets(lumigraph, eye, lumigraph.depth_views), eye,
                                    kAnyDepth, cells);
    return cells;
}

int count_of_marked(const PictureCells& cells) {
    int marked = 0;
    for (int row = 0; row < cells.rows(); ++row)
        for (int column = 0; column < cells.columns(); ++column)
            marked += cells.is_marked(column, row) ? 1 : 0;
    return marked;
}

/// Returns how many pixels there are whose depth no view knows; each must lie in a marked cell.
int expect_unknown_pixels_are_marked(const Lumigraph& lumigraph, const Eye& eye,
                                     const PictureCells& cells) {
    const AgreedDepth depth(lumigraph, view_geometries(lumigraph), eye, {});
    int unknown = 0;
    for (int y = 0; y < eye.camera.height_px; ++y) {
        for (int x = 0; x < eye.camera.width_px; ++x) {
            const Eigen::Vector2d pixel(x + 0.5, y + 0.5);
            bool is_known = true;
            for (const AgreedPixelDepth& sample : depth.samples_at(pixel))
                is_known = is_known && sample.depth.support > 0;
            if (is_known) continue;
            ++unknown;
            EXPECT_TRUE(cells.is_marked(static_cast<int>(pixel.x() / cells.cell_px()),
                                        static_cast<int>(pixel.y() / cells.cell_px())))
                << x << ' ' << y;
        }
    }
    return unknown;
}

TEST(UnknownCells, HoldEveryPixelWhoseDepthNoViewKnows) {
    const Lumigraph lumigraph = card_before_wall();
    int unknown = 0;
    for (const double x : {0.2, 1.0, 2.0, 3.5}) {
        for (const double z : {-2.0, -0.2 * x, 1.0}) {
            const Eye eye = eye_at({x, 0.13, z}, {0, 0, 4}, kLookingCamera);
            unknown += expect_unknown_pixels_are_marked(lumigraph, eye, marked_for(lumigraph, eye));
        }
    }
    EXPECT_GT(unknown, 10000);
}

TEST(UnknownCells, AreFewAmongTheCameras) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.2, 0.13, 0}, {0, 0, 4}, pinhole_camera(240, 180, 400));
    EXPECT_EQ(count_of_marked(marked_for(lumigraph, eye)), 0);
    const Eye beside = eye_at({1.0, 0.13, 0}, {0, 0, 4}, kLookingCamera);
    const PictureCells cells = marked_for(lumigraph, beside);
    EXPECT_GT(count_of_marked(cells), 0);
    EXPECT_LT(count_of_marked(cells), cells.columns() * cells.rows() / 2);
}

/// Depth meshes end at what is infinitely far: behind outlines before it there is nothing.
TEST(UnknownCells, AreAllWhereViewsSeeToInfinity) {
    const Lumigraph lumigraph = ball_in_sky();
    const Eye eye = eye_at({1, -2, -3}, {0, 0, 0}, kLookingCamera);
    const PictureCells cells = marked_for(lumigraph, eye);
    EXPECT_EQ(count_of_marked(cells), cells.columns() * cells.rows());
}

TEST(UnknownCells, AreAllForAnEyeThatIsNearerThanWhatViewsShow) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.2, 0.13, 4}, {0, 0, 6}, kLookingCamera);
    const PictureCells cells = marked_for(lumigraph, eye);
    EXPECT_EQ(count_of_marked(cells), cells.columns() * cells.rows());
}

}  // namespace
}  // namespace lumi
