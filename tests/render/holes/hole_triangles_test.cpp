#include "render/holes/hole_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "render/holes/hole_cells.h"
#include "render/transfer/polygon_clipping.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

double doubled_area_px2(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                        const Eigen::Vector2d& c) {
    return std::abs((b - a).x() * (c - a).y() - (b - a).y() * (c - a).x());
}

class HoleTriangles : public testing::Test {
 protected:
    [[nodiscard]] BlendTriangles triangles_in(const PictureCells& cells) {
        return hole_triangles(lumigraph_, views_, eye_, {}, cells, subdivider_);
    }

    [[nodiscard]] static Eigen::Vector2d corner(const BlendTriangles& triangles, std::size_t i) {
        return vector_of(triangles.vertices[triangles.indices[i]].pixel);
    }

    /// Of what is seen through the mesh, within the cell.
    [[nodiscard]] double area_px2(int column, int row) const {
        const Eigen::Vector2d from = kHoleCell_px * Eigen::Vector2d(column, row);
        const Eigen::AlignedBox2d box(from, from + Eigen::Vector2d::Constant(kHoleCell_px));
        double area = 0;
        for (const FacePolygon& polygon : face_polygons(lumigraph_.mesh, eye_, kNoOverlap_px)) {
            const std::vector<Eigen::Vector2d> part = clipped(polygon.corners_px, box);
            for (std::size_t i = 2; i < part.size(); ++i)
                area += 0.5 * doubled_area_px2(part[0], part[i - 1], part[i]);
        }
        return area;
    }

    Lumigraph lumigraph_ = card_before_wall();
    SearchedViews views_ = searched_views(lumigraph_);
    Eye eye_ = eye_at({0.2, 0.1, 0.05}, {0, 0, 4}, pinhole_camera(160, 120, 140));
    AdaptiveSubdivider subdivider_;
};

TEST_F(HoleTriangles, AreNoneWhereThereIsNoHole) {
    EXPECT_EQ(triangles_in(PictureCells(eye_.camera, kHoleCell_px)).count(), 0U);
}

TEST_F(HoleTriangles, CoverTheCellsAndNothingElse) {
    PictureCells cells(eye_.camera, kHoleCell_px);
    double wanted_px2 = 0;
    for (const auto& [column, row] :
         {std::pair(2, 1), std::pair(3, 1), std::pair(4, 1), std::pair(5, 1), std::pair(7, 5)}) {
        cells.mark(column, row);
        wanted_px2 += area_px2(column, row);
    }
    const BlendTriangles triangles = triangles_in(cells);
    double drawn_px2 = 0;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        drawn_px2 += 0.5 * doubled_area_px2(corner(triangles, i), corner(triangles, i + 1),
                                            corner(triangles, i + 2));
        const Eigen::Vector2d middle =
            (corner(triangles, i) + corner(triangles, i + 1) + corner(triangles, i + 2)) / 3;
        EXPECT_TRUE(cells.is_marked(static_cast<int>(middle.x() / kHoleCell_px),
                                    static_cast<int>(middle.y() / kHoleCell_px)));
    }
    // Faces overlap by a hundredth of a pixel.
    EXPECT_NEAR(drawn_px2, wanted_px2, 0.01 * wanted_px2);
}

TEST_F(HoleTriangles, KeepToTheirOwnCells) {
    PictureCells cells(eye_.camera, kHoleCell_px);
    cells.mark_all();
    const BlendTriangles triangles = triangles_in(cells);
    ASSERT_GT(triangles.count(), 80U);
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        Eigen::AlignedBox2d box;
        for (std::size_t k = i; k < i + 3; ++k) box.extend(corner(triangles, k));
        const Eigen::Array2d cell = (box.center() / kHoleCell_px).array().floor();
        EXPECT_TRUE((box.min().array() >= kHoleCell_px * cell - 1e-3).all());
        EXPECT_TRUE((box.max().array() <= kHoleCell_px * (cell + 1) + 1e-3).all());
    }
}

}  // namespace
}  // namespace lumi
