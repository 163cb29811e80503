#include "render/modes/surroundings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "calib/capture/image_io.h"
#include "render/modes/points_in_view.h"
#include "render/modes/scene_plane.h"

namespace lumi {
namespace {

/// Of the longer side.
constexpr double kSmallPhotograph_px = 16.0;
/// At this angle between view and eye a view counts a quarter.
constexpr double kHalfCloseness_rad = 0.1;
/// So far outside of a photograph, of its shorter side, its border counts a quarter.
constexpr double kHalfReach = 0.05;
/// The mean of all photographs counts where none says anything.
constexpr double kWeightOfMean = 1e-9;

/// Between pixels' centres linearly; beyond them as at the border.
Eigen::Vector3d color_at(const ColorImage& image, double x, double y) {
    const double column = std::clamp(x - 0.5, 0.0, image.width() - 1.0);
    const double row = std::clamp(y - 0.5, 0.0, image.height() - 1.0);
    const int left = std::min(static_cast<int>(column), std::max(0, image.width() - 2));
    const int top = std::min(static_cast<int>(row), std::max(0, image.height() - 2));
    const int right = std::min(left + 1, image.width() - 1);
    const int bottom = std::min(top + 1, image.height() - 1);
    const auto color = [&](int at_x, int at_y) {
        const Rgb8& pixel = image(at_x, at_y);
        return Eigen::Vector3d(pixel.r, pixel.g, pixel.b);
    };
    const double to_right = column - left;
    const double down = row - top;
    return (1 - down) * ((1 - to_right) * color(left, top) + to_right * color(right, top)) +
           down * ((1 - to_right) * color(left, bottom) + to_right * color(right, bottom));
}

Eigen::Vector3d mean_of(const std::vector<ColorImage>& images) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double count = 0;
    for (const ColorImage& image : images) {
        for (const Rgb8& pixel : image.pixels()) sum += Eigen::Vector3d(pixel.r, pixel.g, pixel.b);
        count += static_cast<double>(image.pixels().size());
    }
    return sum / std::max(count, 1.0);
}

/// The corners of marked cells, as indices and as points on the scene plane.
struct CornerPoints {
    std::vector<std::size_t> indices;
    RayPoints on_plane;
};

std::vector<bool> corners_of_marked(const ColorGrid& grid) {
    std::vector<bool> wanted(grid.colors.size());
    for (int row = 0; row < grid.cells.rows(); ++row)
        for (int column = 0; column < grid.cells.columns(); ++column)
            if (grid.cells.is_marked(column, row))
                for (const int down : {0, 1})
                    for (const int right : {0, 1})
                        wanted[grid.corner_index(column + right, row + down)] = true;
    return wanted;
}

CornerPoints corner_points(const Lumigraph& lumigraph, const Eye& eye, const ColorGrid& grid) {
    const std::vector<bool> wanted = corners_of_marked(grid);
    CornerPoints corners;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i]) corners.indices.push_back(i);
    const auto count = static_cast<Eigen::Index>(corners.indices.size());
    corners.on_plane = {Eigen::Matrix3Xd(3, count), Eigen::RowVectorXd(count)};
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    const auto columns = static_cast<std::size_t>(grid.cells.columns() + 1);
    for (Eigen::Index k = 0; k < count; ++k) {
        const std::size_t index = corners.indices[static_cast<std::size_t>(k)];
        const Eigen::Vector2d pixel(static_cast<double>(index % columns) * grid.cells.cell_px(),
                                    static_cast<double>(index / columns) * grid.cells.cell_px());
        corners.on_plane.directions_in_world.col(k) =
            eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
        corners.on_plane.inverse_depths[k] = std::max(0.0, plane.dot(pixel.homogeneous()));
    }
    return corners;
}

/// How much the view counts at each point.
PointsInView::Row weights_of(const Camera& camera, const PointsInView& seen) {
    const PointsInView::Row outside =
        (-seen.to_border_px(camera)).max(0.0) / std::min(camera.width_px, camera.height_px);
    const PointsInView::Row reach = 1 / (1 + outside / kHalfReach);
    const PointsInView::Row closeness = kHalfCloseness_rad / (kHalfCloseness_rad + seen.angles_rad);
    return seen.are_before.select((reach * closeness).square(), 0.0);
}

}  // namespace

Eigen::Vector3f ColorGrid::at(const Eigen::Vector2d& pixel) const {
    const Eigen::Vector2d in_cells = pixel / cells.cell_px();
    const int column = std::clamp(static_cast<int>(in_cells.x()), 0, cells.columns() - 1);
    const int row = std::clamp(static_cast<int>(in_cells.y()), 0, cells.rows() - 1);
    const auto right = static_cast<float>(in_cells.x() - column);
    const auto down = static_cast<float>(in_cells.y() - row);
    const Eigen::Vector3f& start = corner(column, row);
    const Eigen::Vector3f& end = corner(column + 1, row + 1);
    if (right > down)
        return start + right * (corner(column + 1, row) - start) +
               down * (end - corner(column + 1, row));
    return start + down * (corner(column, row + 1) - start) +
           right * (end - corner(column, row + 1));
}

std::vector<ColorImage> small_photographs(const Lumigraph& lumigraph) {
    std::vector<ColorImage> small;
    for (const LumigraphView& view : lumigraph.views) {
        const ColorImage& photograph = view.photograph;
        const double scale =
            std::min(1.0, kSmallPhotograph_px / std::max(photograph.width(), photograph.height()));
        const auto scaled = [scale](int size_px) {
            return std::max(1, static_cast<int>(std::lround(scale * size_px)));
        };
        small.push_back(
            resized(photograph, scaled(photograph.width()), scaled(photograph.height())));
    }
    return small;
}

ColorGrid surrounding_colors(const Lumigraph& lumigraph, const std::vector<ColorImage>& small,
                             const Eye& eye, const PictureCells& cells) {
    ColorGrid grid{cells, {}};
    grid.colors.assign(grid.corner_index(0, cells.rows() + 1), Eigen::Vector3f::Zero());
    const auto [indices, points] = corner_points(lumigraph, eye, grid);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    Eigen::Matrix3Xd sums =
        (kWeightOfMean * mean_of(small)).replicate(1, points.inverse_depths.size());
    PointsInView::Row weight_sums =
        PointsInView::Row::Constant(points.inverse_depths.size(), kWeightOfMean);
    for (std::size_t i = 0; i < small.size(); ++i) {
        const Camera& camera = lumigraph.views[i].camera;
        const PointsInView seen = seen_by(lumigraph.views[i], eye_in_world, points);
        const PointsInView::Row weights = weights_of(camera, seen);
        const double x_scale = static_cast<double>(small[i].width()) / camera.width_px;
        const double y_scale = static_cast<double>(small[i].height()) / camera.height_px;
        for (Eigen::Index k = 0; k < weights.size(); ++k) {
            if (!(weights[k] > 0)) continue;
            sums.col(k) +=
                weights[k] * color_at(small[i], x_scale * seen.x_px[k], y_scale * seen.y_px[k]);
        }
        weight_sums += weights;
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        grid.colors[indices[i]] = (sums.col(k) / weight_sums[k]).cast<float>();
    }
    return grid;
}

ColorImage surroundings_picture(const Lumigraph& lumigraph, const Eye& eye) {
    PictureCells cells(eye.camera);
    cells.mark_all();
    const ColorGrid grid = surrounding_colors(lumigraph, small_photographs(lumigraph), eye, cells);
    ColorImage picture(eye.camera.width_px, eye.camera.height_px);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Eigen::Vector3f color = grid.at({x + 0.5, y + 0.5}).array().round();
            picture(x, y) = {static_cast<std::uint8_t>(color.x()),
                             static_cast<std::uint8_t>(color.y()),
                             static_cast<std::uint8_t>(color.z())};
        }
    }
    return picture;
}

}  // namespace lumi
