#include "render/modes/surroundings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "calib/capture/image_io.h"
#include "render/modes/points_in_view.h"
#include "render/modes/scene_plane.h"

namespace lumi {
namespace {

/// Of the longer side.
constexpr double kSmallPhotograph_px = 16.0;
constexpr double kCellsAcross = 24.0;
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

/// The scene plane at the corners of the grid.
RayPoints corners_on_plane(const Lumigraph& lumigraph, const Eye& eye, const ColorGrid& grid) {
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    const auto count = static_cast<Eigen::Index>(grid.columns) * grid.rows;
    RayPoints points{Eigen::Matrix3Xd(3, count), Eigen::RowVectorXd(count)};
    for (Eigen::Index i = 0; i < count; ++i) {
        const Eigen::Vector2d pixel(static_cast<double>(i % grid.columns) * grid.cell_px,
                                    static_cast<double>(i / grid.columns) * grid.cell_px);
        points.directions_in_world.col(i) =
            eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
        points.inverse_depths[i] = std::max(0.0, plane.dot(pixel.homogeneous()));
    }
    return points;
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
    const Eigen::Vector2d in_cells = pixel / cell_px;
    const int column = std::clamp(static_cast<int>(in_cells.x()), 0, columns - 2);
    const int row = std::clamp(static_cast<int>(in_cells.y()), 0, rows - 2);
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
                             const Eye& eye) {
    ColorGrid grid;
    grid.cell_px = std::max(eye.camera.width_px, eye.camera.height_px) / kCellsAcross;
    grid.columns = 1 + static_cast<int>(std::ceil(eye.camera.width_px / grid.cell_px));
    grid.rows = 1 + static_cast<int>(std::ceil(eye.camera.height_px / grid.cell_px));
    const RayPoints points = corners_on_plane(lumigraph, eye, grid);
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
    for (Eigen::Index k = 0; k < weight_sums.size(); ++k)
        grid.colors.emplace_back((sums.col(k) / weight_sums[k]).cast<float>());
    return grid;
}

}  // namespace lumi
