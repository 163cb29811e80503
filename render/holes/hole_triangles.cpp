#include "render/holes/hole_triangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <utility>
#include <vector>

#include "render/depth_search/depth_search.h"
#include "render/faces/face_polygons.h"
#include "render/subdivision/own_surfaces.h"
#include "render/subdivision/unseen_triangles.h"
#include "render/transfer/polygon_clipping.h"
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

/// Cells beside each other are cut together, but no more than these: one view is to see all of a
/// triangle.
constexpr int kCellsAtOnce = 3;

/// Marked cells of one row, from the first to before the last.
struct CellRun {
    int row;
    int begin_column;
    int end_column;
};

std::vector<CellRun> runs_of(const PictureCells& cells) {
    std::vector<CellRun> runs;
    for (int row = 0; row < cells.rows(); ++row) {
        for (int column = 0; column < cells.columns(); ++column) {
            if (!cells.is_marked(column, row)) continue;
            const bool goes_on = !runs.empty() && runs.back().row == row &&
                                 runs.back().end_column == column &&
                                 column - runs.back().begin_column < kCellsAtOnce;
            if (goes_on)
                ++runs.back().end_column;
            else
                runs.push_back({row, column, column + 1});
        }
    }
    return runs;
}

Eigen::AlignedBox2d box_of(const CellRun& run, double cell_px) {
    return {cell_px * Eigen::Vector2d(run.begin_column, run.row),
            cell_px * Eigen::Vector2d(run.end_column, run.row + 1)};
}

/// The parts of polygons that lie in the runs.
std::vector<FacePolygon> parts_in(const std::vector<CellRun>& runs, double cell_px,
                                  const std::vector<FacePolygon>& polygons) {
    std::vector<FacePolygon> parts;
    for (const FacePolygon& polygon : polygons) {
        Eigen::AlignedBox2d around;
        for (const Eigen::Vector2d& corner : polygon.corners_px) around.extend(corner);
        for (const CellRun& run : runs) {
            const Eigen::AlignedBox2d box = box_of(run, cell_px);
            if (!around.intersects(box)) continue;
            std::vector<Eigen::Vector2d> corners = clipped(polygon.corners_px, box);
            if (corners.size() < 3) continue;
            parts.push_back(polygon);
            parts.back().corners_px = std::move(corners);
        }
    }
    return parts;
}

}  // namespace

BlendTriangles hole_triangles(const Lumigraph& lumigraph, const SearchedViews& views,
                              const Eye& eye, const RenderOptions& options,
                              const PictureCells& holes, AdaptiveSubdivider& subdivider) {
    const std::vector<CellRun> runs = runs_of(holes);
    if (runs.empty()) return {};
    const DepthSearch search(lumigraph, views, eye, options.occlusion_tolerance_px);
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    const PatchSampler::Options sampling = sampling_options(options);
    BlendTriangles triangles =
        subdivider
            .subdivide(parts_in(runs, holes.cell_px(), face_polygons(lumigraph.mesh, eye)), search,
                       plane, sampling, subdivision_options(lumigraph, options))
            .triangles;
    draw_unseen(lumigraph, eye, search, plane, sampling, triangles);
    keep_own_surfaces(search, triangles);
    return triangles;
}

}  // namespace lumi
