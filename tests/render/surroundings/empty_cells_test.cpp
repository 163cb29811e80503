#include "render/surroundings/empty_cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "render/transfer/scene_plane.h"
#include "tests/render/analytic_scene.h"

namespace lumi {
namespace {

const Camera kEyeCamera = pinhole_camera(80, 60, 70);

/// Whether one of the face's cameras shows what lies on the plane behind a pixel.
bool is_shown(const Lumigraph& lumigraph, const FacePolygon& polygon, const Eye& eye,
              const Eigen::Vector3d& plane, const Eigen::Vector2d& pixel) {
    const Eigen::Vector3d direction =
        eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
    const double inverse_depth = std::max(0.0, plane.dot(pixel.homogeneous()));
    const auto weights = weights_at(polygon, pixel);
    for (std::size_t k = 0; k < 3; ++k) {
        const LumigraphView& view =
            lumigraph.views[static_cast<std::size_t>(polygon.view_indices[k])];
        const Eigen::Vector3d in_view =
            view.cam_from_world.rotation * direction +
            inverse_depth * (view.cam_from_world * centre_in_world(eye.cam_from_world));
        const auto at = project(view.camera, in_view);
        if (weights[k] > 0.01 && at && at->x() > 0 && at->y() > 0 &&
            at->x() < view.camera.width_px && at->y() < view.camera.height_px)
            return true;
    }
    return false;
}

TEST(EmptyCells, AreMarkedWhereverAPixelIsNotShown) {
    const Lumigraph lumigraph = card_before_wall();
    const Camera camera = pinhole_camera(240, 180, 210);
    int marked_cells = 0;
    int all_cells = 0;
    for (const double x : {0.2, 1.0, 2.0, 3.5}) {
        const Eye eye = eye_at({x, 0.13, -0.2 * x}, {0, 0, 4}, camera);
        const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
        const auto polygons = face_polygons(lumigraph.mesh, eye);
        PictureCells cells(eye.camera);
        mark_where_none_may_be_shown(polygons, lumigraph.views, eye, plane, cells);
        for (int row = 0; row < cells.rows(); ++row)
            for (int column = 0; column < cells.columns(); ++column, ++all_cells)
                marked_cells += cells.is_marked(column, row) ? 1 : 0;
        for (const FacePolygon& polygon : polygons) {
            Eigen::Vector2d middle(0, 0);
            for (const Eigen::Vector2d& corner : polygon.corners_px)
                middle += corner / static_cast<double>(polygon.corners_px.size());
            for (const Eigen::Vector2d& corner : polygon.corners_px) {
                for (const double share : {0.0, 0.3, 0.6, 0.99}) {
                    const Eigen::Vector2d pixel = middle + share * (corner - middle);
                    if (is_shown(lumigraph, polygon, eye, plane, pixel)) continue;
                    EXPECT_TRUE(cells.is_marked(static_cast<int>(pixel.x() / cells.cell_px()),
                                                static_cast<int>(pixel.y() / cells.cell_px())))
                        << x << ": " << pixel.transpose();
                }
            }
        }
    }
    EXPECT_GT(marked_cells, 0);
    EXPECT_LT(marked_cells, all_cells / 2);
}

TEST(EmptyCells, AreMarkedWhereverThePictureReachesBeyondTheMesh) {
    const Lumigraph lumigraph = card_before_wall();
    const Camera wide = pinhole_camera(80, 60, 12);
    for (const Eye& eye : {eye_at({0.2, 0.1, -300}, {0, 0, 4}, wide),
                           eye_at({200, 0.1, -100}, {0, 0, 4}, kEyeCamera),
                           eye_at({0.2, 0.1, 0}, {0.2, 0.1, -4}, kEyeCamera)}) {
        const auto polygons = face_polygons(lumigraph.mesh, eye);
        PictureCells cells(eye.camera);
        mark_beyond_mesh(lumigraph.mesh, eye, cells);
        const auto is_within = [&](const Eigen::Vector2d& pixel) {
            return std::any_of(polygons.begin(), polygons.end(), [&](const FacePolygon& polygon) {
                return std::all_of(polygon.side_lines.begin(), polygon.side_lines.end(),
                                   [&](const Eigen::Vector3d& line) {
                                       return line.dot(pixel.homogeneous()) >= 0;
                                   });
            });
        };
        int marked = 0;
        int marked_without_need = 0;
        for (int row = 0; row < cells.rows(); ++row) {
            for (int column = 0; column < cells.columns(); ++column) {
                bool is_all_within = true;
                for (double x = 0.25; x < cells.cell_px(); x += 0.5)
                    for (double y = 0.25; y < cells.cell_px(); y += 0.5)
                        if (!is_within({column * cells.cell_px() + x, row * cells.cell_px() + y}))
                            is_all_within = false;
                const bool is_marked = cells.is_marked(column, row);
                EXPECT_TRUE(is_marked || is_all_within) << column << ' ' << row;
                if (is_marked && is_all_within) ++marked_without_need;
                if (is_marked) ++marked;
            }
        }
        EXPECT_GT(marked, 0);
        EXPECT_LE(marked_without_need, 12);
    }
    const Eye among_cameras = eye_at({0.2, 0.13, 0}, {0, 0, 4}, kEyeCamera);
    PictureCells cells(among_cameras.camera);
    mark_beyond_mesh(lumigraph.mesh, among_cameras, cells);
    EXPECT_FALSE(cells.is_any_marked());
}

TEST(EmptyCells, OfATriangleBeyondAPhotographAreThoseItTouches) {
    BlendTriangles triangles;
    for (const std::array<float, 2>& pixel : {std::array<float, 2>{35, 15}, {55, 15}, {35, 25}}) {
        BlendVertex& vertex = triangles.vertices.emplace_back();
        vertex.pixel = pixel;
        vertex.view_pixels[0] = {-5, 3};
        vertex.weights = {1, 0, 0};
        triangles.indices.push_back(static_cast<std::uint32_t>(triangles.indices.size()));
    }
    LumigraphView view;
    view.camera = pinhole_camera(20, 10, 10);
    PictureCells cells(pinhole_camera(240, 240, 100));
    mark_where_none_may_be_shown(triangles, {view}, cells);
    for (int row = 0; row < cells.rows(); ++row)
        for (int column = 0; column < cells.columns(); ++column)
            EXPECT_EQ(cells.is_marked(column, row),
                      column >= 3 && column <= 5 && row >= 1 && row <= 2);
    PictureCells none(pinhole_camera(240, 240, 100));
    for (BlendVertex& vertex : triangles.vertices) vertex.view_pixels[0] = {5, 3};
    mark_where_none_may_be_shown(triangles, {view}, none);
    EXPECT_FALSE(none.is_any_marked());
}

}  // namespace
}  // namespace lumi
