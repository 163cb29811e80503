#include "render/surroundings/empty_cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

#include "calib/capture/inverse_depth_warp.h"
#include "render/transfer/polygon_clipping.h"
#include "render/transfer/polygon_extent.h"

namespace lumi {
namespace {

/// Of a side product, whose sum is 3 at most.
constexpr double kSureSideProduct = 3 * kSureWeight;

bool is_inside(double x, double y, const Camera& camera, double border_px) {
    return x >= border_px && y >= border_px && x <= camera.width_px - border_px &&
           y <= camera.height_px - border_px;
}

using CellCorners = std::array<Eigen::Vector3d, 4>;  ///< Homogeneous pixels.

CellCorners corners_of(const PictureCells& cells, int column, int row) {
    const double left = column * cells.cell_px();
    const double top = row * cells.cell_px();
    const double right = left + cells.cell_px();
    const double bottom = top + cells.cell_px();
    return {Eigen::Vector3d(left, top, 1), Eigen::Vector3d(right, top, 1),
            Eigen::Vector3d(left, bottom, 1), Eigen::Vector3d(right, bottom, 1)};
}

/// Of a cell, in square pixels: what rounding may leave out between faces that fit together.
constexpr double kRounding_px2 = 0.01;

PictureCells::Block touched_by(const FacePolygon& polygon, const PictureCells& cells) {
    const Eigen::AlignedBox2d box = bounding_box(polygon.corners_px);
    return cells.touched_by(box.min(), box.max());
}

/// What is seen through the faces, on the plane and infinitely far beyond its horizon.
class OnPlane {
 public:
    OnPlane(const std::vector<LumigraphView>& views, const Eye& eye, const Eigen::Vector3d& plane,
            double border_px)
        : views_(views), plane_(plane), border_px_(border_px) {
        for (const LumigraphView& view : views) view_from_eye_.push_back(warp_from(eye).to(view));
    }

    [[nodiscard]] bool is_surely_shown(const FacePolygon& polygon,
                                       const CellCorners& corners) const {
        const auto is_beyond = [&](const Eigen::Vector3d& at) { return plane_.dot(at) <= 0; };
        const auto beyond = std::count_if(corners.begin(), corners.end(), is_beyond);
        if (beyond != 0 && beyond != static_cast<std::ptrdiff_t>(corners.size())) return false;
        for (std::size_t k = 0; k < 3; ++k) {
            const Eigen::Matrix3d view_from_eye =
                view_from_plane(polygon.view_indices[k], beyond == 0);
            const Camera& camera = views_[static_cast<std::size_t>(polygon.view_indices[k])].camera;
            const bool is_sure =
                std::all_of(corners.begin(), corners.end(), [&](const Eigen::Vector3d& at) {
                    const Eigen::Vector3d pixel = view_from_eye * at;
                    return polygon.side_lines[k].dot(at) >= kSureSideProduct &&
                           pixel.z() >= kLeastDepthRatio &&
                           is_inside(pixel.x() / pixel.z(), pixel.y() / pixel.z(), camera,
                                     border_px_);
                });
            if (is_sure) return true;
        }
        return false;
    }

 private:
    [[nodiscard]] Eigen::Matrix3d view_from_plane(int view, bool is_near) const {
        const InverseDepthWarp& warp = view_from_eye_[static_cast<std::size_t>(view)];
        return is_near ? warp.homography_of(plane_) : warp.infinite_homography;
    }

    const std::vector<LumigraphView>& views_;
    Eigen::Vector3d plane_;
    double border_px_;
    std::vector<InverseDepthWarp> view_from_eye_;
};

}  // namespace

bool may_show_none(const std::array<const BlendVertex*, 3>& corners,
                   const std::vector<LumigraphView>& views, double border_px) {
    // Places vary projectively on a triangle: what is inside at the corners is inside between them.
    for (std::size_t k = 0; k < 3; ++k) {
        const Camera& camera = views[static_cast<std::size_t>(corners[0]->view_layers[k])].camera;
        const bool is_sure =
            std::all_of(corners.begin(), corners.end(), [&](const BlendVertex* corner) {
                return static_cast<double>(corner->weights[k]) >= kSureWeight &&
                       is_inside(static_cast<double>(corner->view_pixels[k][0]),
                                 static_cast<double>(corner->view_pixels[k][1]), camera, border_px);
            });
        if (is_sure) return false;
    }
    return true;
}

void mark_where_none_may_be_shown(const BlendTriangles& triangles,
                                  const std::vector<LumigraphView>& views, PictureCells& cells,
                                  double border_px) {
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        std::array<const BlendVertex*, 3> corners{};
        Eigen::Matrix<double, 2, 3> pixels;
        for (std::size_t k = 0; k < 3; ++k) {
            corners[k] = &triangles.vertices[triangles.indices[i + k]];
            pixels.col(static_cast<Eigen::Index>(k)) << corners[k]->pixel[0], corners[k]->pixel[1];
        }
        if (!may_show_none(corners, views, border_px)) continue;
        const PictureCells::Block block =
            cells.touched_by(pixels.rowwise().minCoeff(), pixels.rowwise().maxCoeff());
        for (int row = block.begin_row; row < block.end_row; ++row)
            for (int column = block.begin_column; column < block.end_column; ++column)
                cells.mark(column, row);
    }
}

void mark_where_none_may_be_shown(const std::vector<FacePolygon>& polygons,
                                  const std::vector<LumigraphView>& views, const Eye& eye,
                                  const Eigen::Vector3d& plane, PictureCells& cells,
                                  double border_px) {
    const OnPlane on_plane(views, eye, plane, border_px);
    for (const FacePolygon& polygon : polygons) {
        if (polygon.corners_px.empty()) continue;
        const PictureCells::Block block = touched_by(polygon, cells);
        for (int row = block.begin_row; row < block.end_row; ++row)
            for (int column = block.begin_column; column < block.end_column; ++column)
                if (!cells.is_marked(column, row) &&
                    !on_plane.is_surely_shown(polygon, corners_of(cells, column, row)))
                    cells.mark(column, row);
    }
}

void mark_beyond_mesh(const CameraMesh& mesh, const Eye& eye, PictureCells& cells) {
    const double cell_px = cells.cell_px();
    Eigen::MatrixXd open_px2(cells.rows(), cells.columns());
    for (int row = 0; row < cells.rows(); ++row)
        for (int column = 0; column < cells.columns(); ++column)
            open_px2(row, column) = std::min(cell_px, eye.camera.width_px - column * cell_px) *
                                    std::min(cell_px, eye.camera.height_px - row * cell_px);
    // Faces do not overlap: areas add up.
    for (const FacePolygon& polygon : face_polygons(mesh, eye, kNoOverlap_px)) {
        const PictureCells::Block block = touched_by(polygon, cells);
        for (int row = block.begin_row; row < block.end_row; ++row) {
            const std::vector<Eigen::Vector2d> in_row =
                clipped_between(polygon.corners_px, 1, row * cell_px, (row + 1) * cell_px);
            for (int column = block.begin_column; column < block.end_column; ++column)
                open_px2(row, column) -=
                    area_px2(clipped_between(in_row, 0, column * cell_px, (column + 1) * cell_px));
        }
    }
    for (int row = 0; row < cells.rows(); ++row)
        for (int column = 0; column < cells.columns(); ++column)
            if (open_px2(row, column) > kRounding_px2) cells.mark(column, row);
}

}  // namespace lumi
