#include "meshing/fusion/surface_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lumi {

double Acuity::cell_size(const Eigen::Vector3d& place, double spacing_px) const {
    constexpr double kNoisePx = 0.25;
    const double distance = (place - centre_in_world).norm();
    const double wide = spacing_px * distance / focal_length_px;
    const double deep = kNoisePx * distance * distance / (focal_length_px * baseline);
    return std::max(wide, deep);
}

std::size_t SurfaceGrid::KeyHash::operator()(const Key& key) const {
    std::uint64_t hash = 0;
    for (const std::int64_t part : key) {
        hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
}

SurfaceGrid::SurfaceGrid(std::vector<Acuity> views, double spacing_px)
    : spacing_px_(spacing_px), views_(std::move(views)) {}

void SurfaceGrid::add(const SurfaceSample& sample) {
    double wanted = std::numeric_limits<double>::infinity();
    double squared_reach = wanted;  // In focal lengths of a view that wants less.
    for (const Acuity& view : views_) {
        // No view wants cells smaller than its pixels are wide there: most need no square root.
        const double squared_distance = (sample.position - view.centre_in_world).squaredNorm();
        if (squared_distance >= squared_reach * view.focal_length_px * view.focal_length_px)
            continue;
        wanted = std::min(wanted, view.cell_size(sample.position, spacing_px_));
        squared_reach = std::pow(wanted / spacing_px_, 2);
    }
    const double level = std::round(std::log2(wanted));
    if (!std::isfinite(level)) return;
    const double size = std::exp2(level);
    const Eigen::Vector3d place = (sample.position / size).array().floor();
    constexpr double kFarthest = 1e15;
    if (place.cwiseAbs().maxCoeff() > kFarthest) return;
    Cell& cell =
        cells_[{static_cast<std::int64_t>(level), static_cast<std::int64_t>(place.x()),
                static_cast<std::int64_t>(place.y()), static_cast<std::int64_t>(place.z())}];
    const auto weight = static_cast<float>(sample.weight);
    cell.position += sample.weight * sample.position;
    cell.normal += weight * sample.normal.cast<float>();
    cell.color += weight * Eigen::Vector3f(sample.color.r, sample.color.g, sample.color.b);
    cell.weight += sample.weight;
    cell.size = static_cast<float>(size);
    ++cell.samples;
}

std::vector<SurfacePoint> SurfaceGrid::points() const {
    constexpr int kMinSamples = 2;
    constexpr double kMinUnanimity = 0.5;
    std::vector<std::pair<Key, const Cell*>> ordered;
    for (const auto& [key, cell] : cells_) {
        const auto agreeing_weight = static_cast<double>(cell.normal.norm());
        if (cell.samples >= kMinSamples && agreeing_weight >= kMinUnanimity * cell.weight) {
            ordered.emplace_back(key, &cell);
        }
    }
    std::sort(ordered.begin(), ordered.end());
    std::vector<SurfacePoint> points;
    for (const auto& [key, cell] : ordered) {
        const Eigen::Vector3f color = cell->color / static_cast<float>(cell->weight);
        const auto level = [&](int channel) {
            return static_cast<std::uint8_t>(std::clamp(color[channel] + 0.5F, 0.0F, 255.0F));
        };
        points.push_back({cell->position / cell->weight,
                          cell->normal.normalized(),
                          {level(0), level(1), level(2)},
                          cell->size});
    }
    return points;
}

}  // namespace lumi
