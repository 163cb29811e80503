#include "render/surroundings/surroundings.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "render/depth_search/points_in_view.h"
#include "render/transfer/sampling.h"
#include "render/transfer/scene_plane.h"

namespace lumi {
namespace {

/// At this angle between view and eye a view counts a quarter.
constexpr double kHalfCloseness_rad = 0.1;
/// So far outside of a photograph, of its shorter side, its border counts a quarter.
constexpr double kHalfReach = 0.05;
/// So many views count at most: of hundreds, most look at something else.
constexpr std::size_t kMostViews = 12;
/// The mean of all photographs counts where none says anything.
constexpr double kWeightOfMean = 1e-9;

/// What the eye sees of the scene plane at these pixels.
RayPoints points_on_plane(const Lumigraph& lumigraph, const Eye& eye,
                          const std::vector<Eigen::Vector2d>& pixels) {
    const auto count = static_cast<Eigen::Index>(pixels.size());
    RayPoints points{Eigen::Matrix3Xd(3, count), Eigen::RowVectorXd(count)};
    const Eigen::Vector3d plane = scene_plane_inverse_depth(lumigraph, eye);
    for (Eigen::Index k = 0; k < count; ++k) {
        const Eigen::Vector2d& pixel = pixels[static_cast<std::size_t>(k)];
        points.directions_in_world.col(k) =
            eye.cam_from_world.rotation.conjugate() * unproject(eye.camera, pixel);
        points.inverse_depths[k] = std::max(0.0, plane.dot(pixel.homogeneous()));
    }
    return points;
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
    const auto columns = static_cast<std::size_t>(grid.cells.columns() + 1);
    std::vector<Eigen::Vector2d> pixels;
    for (const std::size_t index : corners.indices)
        pixels.emplace_back(static_cast<double>(index % columns) * grid.cells.cell_px(),
                            static_cast<double>(index / columns) * grid.cells.cell_px());
    corners.on_plane = points_on_plane(lumigraph, eye, pixels);
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

/// A view, and how much of its weight it keeps.
struct KeptView {
    std::size_t index;
    double share;
};

/// The views that weigh most in the picture's middle and corners. The next one, and with it each
/// that comes or goes as the eye moves, would keep nothing.
std::vector<KeptView> kept_views(const Lumigraph& lumigraph, const Eye& eye) {
    std::vector<KeptView> kept;
    const double right = eye.camera.width_px;
    const double bottom = eye.camera.height_px;
    const RayPoints looked_at = points_on_plane(
        lumigraph, eye,
        {{0, 0}, {right, 0}, {0, bottom}, {right, bottom}, {0.5 * right, 0.5 * bottom}});
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        const LumigraphView& view = lumigraph.views[i];
        kept.push_back({i, weights_of(view.camera, seen_by(view, eye_in_world, looked_at)).sum()});
    }
    if (kept.size() <= kMostViews) {
        for (KeptView& view : kept) view.share = 1;
        return kept;
    }
    const auto next = kept.begin() + kMostViews;
    std::nth_element(kept.begin(), next, kept.end(),
                     [](const KeptView& a, const KeptView& b) { return a.share > b.share; });
    const double weight_of_next = next->share;
    kept.erase(next, kept.end());
    for (KeptView& view : kept) view.share = view.share > 0 ? 1 - weight_of_next / view.share : 0;
    return kept;
}

}  // namespace

Eigen::Vector3f ColorGrid::at(const Eigen::Vector2d& pixel,
                              const Eigen::Vector2d& on_triangle) const {
    const Eigen::Vector2d in_cells = pixel / cells.cell_px();
    const Eigen::Vector2d triangle_in_cells = on_triangle / cells.cell_px();
    const int column = std::clamp(static_cast<int>(triangle_in_cells.x()), 0, cells.columns() - 1);
    const int row = std::clamp(static_cast<int>(triangle_in_cells.y()), 0, cells.rows() - 1);
    const auto right = static_cast<float>(in_cells.x() - column);
    const auto down = static_cast<float>(in_cells.y() - row);
    const Eigen::Vector3f& start = corner(column, row);
    const Eigen::Vector3f& end = corner(column + 1, row + 1);
    // On the diagonal the upper one, as in OpenGL.
    if (triangle_in_cells.x() - column >= triangle_in_cells.y() - row)
        return start + right * (corner(column + 1, row) - start) +
               down * (end - corner(column + 1, row));
    return start + down * (corner(column, row + 1) - start) +
           right * (end - corner(column, row + 1));
}

ColorGrid surrounding_colors(const Lumigraph& lumigraph, const SmallPhotographs& small,
                             const Eye& eye, const PictureCells& cells) {
    ColorGrid grid{cells, {}};
    grid.colors.assign(grid.corner_index(0, cells.rows() + 1), Eigen::Vector3f::Zero());
    const auto [indices, points] = corner_points(lumigraph, eye, grid);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    Eigen::Matrix3Xd sums = (kWeightOfMean * small.mean).replicate(1, points.inverse_depths.size());
    PointsInView::Row weight_sums =
        PointsInView::Row::Constant(points.inverse_depths.size(), kWeightOfMean);
    for (const auto& [index, share] : kept_views(lumigraph, eye)) {
        const LumigraphView& view = lumigraph.views[index];
        const PointsInView seen = seen_by(view, eye_in_world, points);
        const PointsInView::Row weights = share * weights_of(view.camera, seen);
        const ColorImage& photograph = small.of_views[index];
        const double x_scale = static_cast<double>(photograph.width()) / view.camera.width_px;
        const double y_scale = static_cast<double>(photograph.height()) / view.camera.height_px;
        for (Eigen::Index k = 0; k < weights.size(); ++k) {
            if (!(weights[k] > 0)) continue;
            sums.col(k) +=
                weights[k] * bilinear(photograph, {x_scale * seen.x_px[k], y_scale * seen.y_px[k]});
        }
        weight_sums += weights;
    }
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        grid.colors[indices[i]] = (sums.col(k) / weight_sums[k]).cast<float>();
    }
    return grid;
}

ColorImage surroundings_picture(const Lumigraph& lumigraph, const Eye& eye, int block_side_px) {
    PictureCells cells(eye.camera);
    cells.mark_all();
    const ColorGrid grid = surrounding_colors(lumigraph, small_photographs(lumigraph), eye, cells);
    ColorImage picture(eye.camera.width_px, eye.camera.height_px);
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const Eigen::Vector2d block(x / block_side_px, y / block_side_px);
            const Eigen::Vector3f color =
                grid.at({x + 0.5, y + 0.5},
                        block_side_px * (block + Eigen::Vector2d::Constant(0.5)))
                    .cwiseMax(0)
                    .cwiseMin(255)
                    .array()
                    .round();
            picture(x, y) = {static_cast<std::uint8_t>(color.x()),
                             static_cast<std::uint8_t>(color.y()),
                             static_cast<std::uint8_t>(color.z())};
        }
    }
    return picture;
}

}  // namespace lumi
