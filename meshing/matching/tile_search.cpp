#include "meshing/matching/tile_search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

namespace lumi {
namespace {

/// A pixel of the guiding map, relative to the centre of a tile.
struct Sample {
    Eigen::Vector2d offset_px;
    double inverse_depth;
};

Eigen::Vector2d centre_of_tile(int column, int row) {
    return {kTileSide * (column + 0.5), kTileSide * (row + 0.5)};
}

/// The map's pixels in the tile and half a tile around it.
std::vector<Sample> samples_around(const FloatImage& found, int width, int height, int column,
                                   int row) {
    const double scale_x = static_cast<double>(found.width()) / width;
    const double scale_y = static_cast<double>(found.height()) / height;
    const auto first = [](int tile, double scale, int size) {
        return std::clamp(static_cast<int>((tile - 0.5) * kTileSide * scale), 0, size - 1);
    };
    const auto end = [](int tile, double scale, int size) {
        return std::clamp(static_cast<int>((tile + 1.5) * kTileSide * scale), 1, size);
    };
    std::vector<Sample> samples;
    for (int y = first(row, scale_y, found.height()); y < end(row, scale_y, found.height()); ++y) {
        // Every second pixel, as on a chessboard: a plane needs no more.
        for (int x = first(column, scale_x, found.width()) + y % 2;
             x < end(column, scale_x, found.width()); x += 2) {
            const Eigen::Vector2d pixel((x + 0.5) / scale_x, (y + 0.5) / scale_y);
            samples.push_back(
                {pixel - centre_of_tile(column, row), static_cast<double>(found(x, y))});
        }
    }
    return samples;
}

/// Sums for the plane of least squares through samples.
struct PlaneFit {
    double xx = 0, xy = 0, yy = 0, x = 0, y = 0, xq = 0, yq = 0, q = 0;
    std::size_t count = 0;

    void add(const Sample& sample) {
        const Eigen::Vector2d& at = sample.offset_px;
        xx += at.x() * at.x();
        xy += at.x() * at.y();
        yy += at.y() * at.y();
        x += at.x();
        y += at.y();
        xq += at.x() * sample.inverse_depth;
        yq += at.y() * sample.inverse_depth;
        q += sample.inverse_depth;
        ++count;
    }
    [[nodiscard]] Eigen::Vector2d slope() const {
        constexpr double kRidge = 1e-3;  // A strip of one pixel tells no slope across it.
        const auto n = static_cast<double>(count);
        Eigen::Matrix3d normal;
        normal << xx + kRidge, xy, x, xy, yy + kRidge, y, x, y, n;
        return normal.ldlt().solve(Eigen::Vector3d(xq, yq, q)).head<2>();
    }
};

Eigen::Vector2d fitted_slope(const std::vector<Sample>& samples) {
    PlaneFit fit;
    for (const Sample& sample : samples) fit.add(sample);
    return fit.slope();
}

std::vector<double> residuals(const std::vector<Sample>& samples, const Eigen::Vector2d& slope) {
    std::vector<double> result;
    result.reserve(samples.size());
    for (const Sample& sample : samples) {
        result.push_back(sample.inverse_depth - slope.dot(sample.offset_px));
    }
    return result;
}

/// The samples that lie within a tolerance of the middle one, once a slope is taken away.
struct Followers {
    std::vector<double> values;  ///< Of all samples.
    double middle = 0;
    std::size_t count = 0;
};

Followers followers(const std::vector<Sample>& samples, const Eigen::Vector2d& slope,
                    double tolerance, std::vector<double>& scratch) {
    Followers result{residuals(samples, slope)};
    scratch = result.values;
    const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
    std::nth_element(scratch.begin(), middle, scratch.end());
    result.middle = *middle;
    result.count = static_cast<std::size_t>(
        std::count_if(result.values.begin(), result.values.end(),
                      [&](double value) { return std::abs(value - result.middle) <= tolerance; }));
    return result;
}

/// Through the samples on one side of the tile's centre, for each of the four sides, after all.
std::array<PlaneFit, 5> fits_of(const std::vector<Sample>& samples) {
    std::array<PlaneFit, 5> fits;
    for (const Sample& sample : samples) {
        fits[0].add(sample);
        fits[sample.offset_px.x() < 0 ? 1 : 2].add(sample);
        fits[sample.offset_px.y() < 0 ? 3 : 4].add(sample);
    }
    return fits;
}

/// The slope that most samples follow: of all of them or of one half, so that a step between two
/// surfaces does not pass for a slope. Frontal unless clearly more follow the slope.
Eigen::Vector2d supported_slope(const std::vector<Sample>& samples, double tolerance) {
    constexpr double kClearly = 1.1;
    constexpr double kLeastShare = 0.4;
    std::vector<double> scratch;
    Followers best;
    for (const PlaneFit& fit : fits_of(samples)) {
        if (fit.count < 3) continue;
        Followers following = followers(samples, fit.slope(), tolerance, scratch);
        if (following.count > best.count) best = std::move(following);
    }
    const Followers frontal = followers(samples, Eigen::Vector2d::Zero(), tolerance, scratch);
    const auto required = std::max(kClearly * static_cast<double>(frontal.count),
                                   kLeastShare * static_cast<double>(samples.size()));
    if (static_cast<double>(best.count) < required) return Eigen::Vector2d::Zero();
    PlaneFit of_followers;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (std::abs(best.values[i] - best.middle) <= tolerance) of_followers.add(samples[i]);
    }
    return of_followers.slope();
}

/// What the values span but for so many at either end.
InverseDepthRange range_without_ends(std::vector<double> values, std::size_t cut) {
    const auto far = values.begin() + static_cast<std::ptrdiff_t>(cut);
    std::nth_element(values.begin(), far, values.end());
    const auto near = values.end() - 1 - static_cast<std::ptrdiff_t>(cut);
    std::nth_element(far, near, values.end());
    return {*far, *near};
}

/// Where the values of the samples lie: all in the tile itself, and of those around it all but a
/// twentieth at either end. What is farther off there is a mismatch more often than a surface, and
/// nine tiles would be searched that far for it.
InverseDepthRange range_of(const std::vector<Sample>& samples, const std::vector<double>& values) {
    InverseDepthRange range = range_without_ends(values, values.size() / 20);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        if (samples[i].offset_px.cwiseAbs().maxCoeff() > 0.5 * kTileSide) continue;
        range.far = std::min(range.far, values[i]);
        range.near = std::max(range.near, values[i]);
    }
    return range;
}

}  // namespace

std::vector<TileSurface> search_around(const FloatImage& found, int width, int height,
                                       double tolerance) {
    std::vector<TileSurface> tiles;
    for (int row = 0; row < tiles_along(height); ++row) {
        for (int column = 0; column < tiles_along(width); ++column) {
            const std::vector<Sample> samples = samples_around(found, width, height, column, row);
            const Eigen::Vector2d slope = supported_slope(samples, tolerance);
            const std::vector<double> values = residuals(samples, slope);
            tiles.push_back(
                {range_of(samples, values), range_without_ends(values, values.size() / 5), slope});
        }
    }
    return tiles;
}

std::vector<TileSurface> search_whole_range(const InverseDepthRange& range, int width, int height,
                                            const FloatImage& guide) {
    const auto count = static_cast<std::size_t>(tiles_along(width) * tiles_along(height));
    std::vector<TileSurface> tiles(count, TileSurface{range, range, Eigen::Vector2d::Zero()});
    if (guide.empty()) return tiles;
    for (int row = 0; row < tiles_along(height); ++row) {
        for (int column = 0; column < tiles_along(width); ++column) {
            tiles[static_cast<std::size_t>(row * tiles_along(width) + column)].slope =
                fitted_slope(samples_around(guide, width, height, column, row));
        }
    }
    return tiles;
}

void include_points(const DepthView& view, double scale, int width,
                    std::vector<TileSurface>& tiles) {
    const int across = tiles_along(width);
    for (const SparsePoint& point : view.points) {
        const Eigen::Vector2d pixel = scale * point.pixel;
        const int column = std::min(static_cast<int>(pixel.x()) / kTileSide, across - 1);
        const int row = static_cast<int>(pixel.y()) / kTileSide;
        const int index = row * across + column;
        if (index >= static_cast<int>(tiles.size())) continue;
        TileSurface& tile = tiles[static_cast<std::size_t>(index)];
        const double at_centre = std::clamp(point.inverse_depth, view.range.far, view.range.near) -
                                 tile.slope.dot(pixel - centre_of_tile(column, row));
        tile.at_centre.far = std::min(tile.at_centre.far, at_centre);
        tile.at_centre.near = std::max(tile.at_centre.near, at_centre);
    }
}

}  // namespace lumi
