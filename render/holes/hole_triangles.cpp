#include "render/holes/hole_triangles.h"

#include <Eigen/Geometry>
#include <utility>
#include <vector>

#include "render/depth_search/depth_search.h"
#include "render/faces/face_polygons.h"
#include "render/subdivision/own_surfaces.h"
#include "render/subdivision/unseen_triangles.h"
#include "render/transfer/polygon_clipping.h"
#include "render/transfer/polygon_extent.h"
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

Eigen::AlignedBox2d box_of(int column, int row, double cell_px) {
    return {cell_px * Eigen::Vector2d(column, row), cell_px * Eigen::Vector2d(column + 1, row + 1)};
}

/// The parts of polygons that lie in marked cells, cell by cell: one view is to see all of a
/// triangle.
std::vector<FacePolygon> parts_in(const PictureCells& cells,
                                  const std::vector<FacePolygon>& polygons) {
    std::vector<FacePolygon> parts;
    for (const FacePolygon& polygon : polygons) {
        const Eigen::AlignedBox2d around = bounding_box(polygon.corners_px);
        const PictureCells::Block block = cells.touched_by(around.min(), around.max());
        for (int row = block.begin_row; row < block.end_row; ++row) {
            for (int column = block.begin_column; column < block.end_column; ++column) {
                if (!cells.is_marked(column, row)) continue;
                std::vector<Eigen::Vector2d> corners =
                    clipped(polygon.corners_px, box_of(column, row, cells.cell_px()));
                if (corners.size() < 3) continue;
                parts.push_back(polygon);
                parts.back().corners_px = std::move(corners);
            }
        }
    }
    return parts;
}

}  // namespace

BlendTriangles hole_triangles(const Lumigraph& lumigraph, const SearchedViews& views,
                              const Eye& eye, const RenderOptions& options,
                              const PictureCells& holes, AdaptiveSubdivider& subdivider) {
    if (!holes.is_any_marked()) return {};
    const DepthSearch search(lumigraph, views, eye);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    const PatchSampler::Options sampling = sampling_options(options);
    BlendTriangles triangles =
        subdivider
            .subdivide(parts_in(holes, face_polygons(lumigraph.mesh, eye)), search, plane, sampling,
                       subdivision_options(lumigraph, options))
            .triangles;
    // Cells are small: what is seen of them in part changed no picture.
    draw_unseen(lumigraph, eye, search, plane, sampling, triangles);
    keep_own_surfaces(search, triangles);
    return triangles;
}

}  // namespace lumi
