#include "render/view_choice/nearest_views.h"

#include <algorithm>
#include <cmath>

#include "calib/work/parallel_for.h"
#include "render/view_choice/view_sight.h"

namespace lumi {
namespace {

constexpr auto kSteps = static_cast<std::size_t>(kSightSteps);

/// How near each view comes to the eye's direction: one row a view, one column a pixel.
Eigen::MatrixXd closeness_of_views(const Lumigraph& lumigraph, const Eye& eye,
                                   const std::vector<Eigen::Vector2d>& pixels) {
    const SightSamples samples = sight_samples(lumigraph, eye, pixels);
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    const auto count = static_cast<Eigen::Index>(pixels.size());
    Eigen::MatrixXd closeness(static_cast<Eigen::Index>(lumigraph.views.size()), count);
    parallel_for(static_cast<int>(closeness.rows()), 0, [&](int view) {
        const Eigen::RowVectorXd worth =
            sight_of(lumigraph.views[static_cast<std::size_t>(view)], eye_in_world, samples.points)
                .closeness.cwiseProduct(samples.worth);
        closeness.row(view) = worth.head(count) + worth.tail(count);
    });
    return closeness;
}

/// The indices of what is above 0, the largest first.
std::vector<int> in_order(const Eigen::VectorXd& closeness, std::size_t most) {
    std::vector<int> views;
    for (Eigen::Index view = 0; view < closeness.size(); ++view)
        if (closeness[view] > 0) views.push_back(static_cast<int>(view));
    const std::size_t count = std::min(views.size(), most);
    std::partial_sort(views.begin(), views.begin() + static_cast<std::ptrdiff_t>(count),
                      views.end(), [&](int a, int b) {
                          return closeness[a] != closeness[b] ? closeness[a] > closeness[b] : a < b;
                      });
    views.resize(count);
    return views;
}

std::size_t step_of(double pixel, int size_px) {
    return static_cast<std::size_t>(
        std::clamp(std::floor(pixel * kSightSteps / size_px), 0.0, kSightSteps - 1.0));
}

}  // namespace

NearestViews::NearestViews(const Lumigraph& lumigraph, const Eye& eye,
                           const std::vector<Eigen::Vector2d>& pixels, std::size_t most)
    : camera_(eye.camera), views_of_cell_(kSteps * kSteps) {
    if (pixels.empty()) return;
    std::vector<std::size_t> cells;
    for (const Eigen::Vector2d& pixel : pixels) cells.push_back(cell_of(pixel));
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    std::vector<Eigen::Vector2d> middles;
    for (const std::size_t cell : cells) middles.push_back(middle_of(cell));
    const Eigen::MatrixXd closeness = closeness_of_views(lumigraph, eye, middles);
    for (std::size_t i = 0; i < cells.size(); ++i)
        views_of_cell_[cells[i]] = in_order(closeness.col(static_cast<Eigen::Index>(i)), most);
}

const std::vector<int>& NearestViews::at(const Eigen::Vector2d& pixel) const {
    return views_of_cell_[cell_of(pixel)];
}

std::size_t NearestViews::cell_of(const Eigen::Vector2d& pixel) const {
    return step_of(pixel.y(), camera_.height_px) * kSteps + step_of(pixel.x(), camera_.width_px);
}

Eigen::Vector2d NearestViews::middle_of(std::size_t cell) const {
    const auto column = static_cast<double>(cell % kSteps);
    const auto row = static_cast<double>(cell / kSteps);
    return {(column + 0.5) * camera_.width_px / kSightSteps,
            (row + 0.5) * camera_.height_px / kSightSteps};
}

}  // namespace lumi
