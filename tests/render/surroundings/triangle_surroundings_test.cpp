#include "render/surroundings/triangle_surroundings.h"

#include <gtest/gtest.h>

#include <array>

#include "render/modes/adaptive.h"
#include "render/surroundings/empty_cells.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

BlendTriangles triangles_from(const Lumigraph& lumigraph, const Eye& eye) {
    return adaptive_layers(lumigraph, searched_views(lumigraph), eye,
                           {.mode = RenderMode::kAdaptive})
        .front();
}

/// Of the whole picture.
ColorGrid colors_of_all(const Lumigraph& lumigraph, const Eye& eye) {
    PictureCells cells(eye.camera);
    cells.mark_all();
    return surrounding_colors(lumigraph, small_photographs(lumigraph), eye, cells);
}

TEST(TriangleSurroundings, AreThoseOfThePictureWherePhotographsEnd) {
    const Lumigraph lumigraph = card_before_wall();
    const Camera camera = pinhole_camera(160, 120, 70);  // Sees more than the photographs.
    const Eye eye = eye_at({0.3, 0.1, -1}, {0, 0, 4}, camera);
    BlendTriangles triangles = triangles_from(lumigraph, eye);
    set_surroundings(lumigraph, small_photographs(lumigraph), eye, triangles);
    const ColorGrid colors = colors_of_all(lumigraph, eye);
    int asked = 0;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const std::array<const BlendVertex*, 3> corners{
            &triangles.vertices[triangles.indices[i]],
            &triangles.vertices[triangles.indices[i + 1]],
            &triangles.vertices[triangles.indices[i + 2]]};
        if (!may_show_none(corners, lumigraph.views)) continue;
        for (const BlendVertex* corner : corners) {
            const Eigen::Vector3f there = colors.at(vector_of(corner->pixel));
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(corner->surroundings[k], there[static_cast<Eigen::Index>(k)], 1e-3);
            ++asked;
        }
    }
    EXPECT_GT(asked, 20);
}

TEST(TriangleSurroundings, OfNoTrianglesAreNone) {
    const Lumigraph lumigraph = card_before_wall();
    const Eye eye = eye_at({0.2, 0.1, 0.5}, {0, 0, 4}, pinhole_camera(80, 60, 140));
    BlendTriangles triangles;
    triangles.vertices.resize(3);
    set_surroundings(lumigraph, small_photographs(lumigraph), eye, triangles);
    for (const BlendVertex& vertex : triangles.vertices) EXPECT_LT(vertex.surroundings[0], 0);
}

}  // namespace
}  // namespace lumi
