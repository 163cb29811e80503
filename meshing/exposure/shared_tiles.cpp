#include "meshing/exposure/shared_tiles.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "calib/capture/light_left.h"
#include "calib/pictures/lost_color.h"
#include "calib/pictures/srgb_curve.h"
#include "calib/work/mean.h"
#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "meshing/warp/round_trip.h"

namespace lumi {
namespace {

constexpr int kGridWidth = 96;
constexpr int kTile = 8;  // Cells.
constexpr std::size_t kLeastSamples = 6;
constexpr std::size_t kPartners = 8;
constexpr int kSaturated = 250;
constexpr float kLeastLight = 0.008F;  // About 22 of 255.
constexpr double kSameSurfaceCells = 0.5;
constexpr int kSightStep = 12;  // Cells between the places by which partners are found.

/// The mean light of the pixels around a place; negative where one is nearly black or saturated.
Eigen::Vector3f light_of_cell(const ColorImage& photograph, int left, int top, int right,
                              int bottom) {
    const std::array<float, 256>& light = light_of_srgb_bytes();
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) {
            const Rgb8& pixel = photograph(x, y);
            if (std::max({pixel.r, pixel.g, pixel.b}) > kSaturated) {
                return Eigen::Vector3f::Constant(-1.0F);
            }
            sum += Eigen::Vector3f(light[pixel.r], light[pixel.g], light[pixel.b]);
        }
    }
    const Eigen::Vector3f mean = sum / static_cast<float>((right - left) * (bottom - top));
    return mean.minCoeff() < kLeastLight ? Eigen::Vector3f::Constant(-1.0F) : mean;
}

/// A view on a coarse raster.
struct LightGrid {
    Camera camera;
    Rigid3 cam_from_world;
    Image<Eigen::Vector3f> light;  ///< Negative where it says nothing.
    FloatImage inverse_depth;      ///< Negative where it was not seen.
};

LightGrid grid_of(const PicturedView& view, const ColorImage& photograph) {
    const int width = std::min(kGridWidth, photograph.width());
    const int height = std::max(1, photograph.height() * width / photograph.width());
    LightGrid grid{resized(view.camera, width, height), view.cam_from_world,
                   Image<Eigen::Vector3f>(width, height, Eigen::Vector3f::Zero()),
                   FloatImage(width, height, -1.0F)};
    const FloatImage& inverse_depth = view.depth->inverse_depth;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            grid.light(x, y) = light_of_cell(
                photograph, x * photograph.width() / width, y * photograph.height() / height,
                (x + 1) * photograph.width() / width, (y + 1) * photograph.height() / height);
            if (inverse_depth.empty()) continue;
            const int column = (2 * x + 1) * inverse_depth.width() / (2 * width);
            const int row = (2 * y + 1) * inverse_depth.height() / (2 * height);
            if (was_seen(view.depth->confidence(column, row))) {
                grid.inverse_depth(x, y) = inverse_depth(column, row);
            }
        }
    }
    return grid;
}

/// Where a cell's surface lies in the other view's raster, when it does.
std::optional<Eigen::Vector2d> place_in(const LightGrid& other, const InverseDepthWarp& warp, int x,
                                        int y, double inverse_depth) {
    const auto at = warp.at({x + 0.5, y + 0.5}, inverse_depth);
    if (!at) return std::nullopt;
    const Eigen::Vector2d& place = at->pixel;
    const bool is_within = place.x() >= 0.5 && place.y() >= 0.5 &&
                           place.x() <= other.camera.width_px - 0.5 &&
                           place.y() <= other.camera.height_px - 0.5;
    return is_within ? std::optional(place) : std::nullopt;
}

/// The share of a view's places, on a very coarse raster, that another view has in its picture.
double shared_sight(const LightGrid& view, const LightGrid& other) {
    const InverseDepthWarp warp = warp_from(view).to(other);
    int known = 0;
    int seen = 0;
    for (int y = kSightStep / 2; y < view.inverse_depth.height(); y += kSightStep) {
        for (int x = kSightStep / 2; x < view.inverse_depth.width(); x += kSightStep) {
            const float inverse_depth = view.inverse_depth(x, y);
            if (inverse_depth < 0) continue;
            ++known;
            if (place_in(other, warp, x, y, static_cast<double>(inverse_depth))) ++seen;
        }
    }
    return known == 0 ? 0.0 : static_cast<double>(seen) / known;
}

/// Each pair once, the lower index first. Of partners that share as much the nearer come first.
std::vector<std::pair<int, int>> partners_of_all(const std::vector<LightGrid>& grids, int threads) {
    std::vector<std::vector<int>> partners(grids.size());
    parallel_for(static_cast<int>(grids.size()), threads, [&](int i) {
        const LightGrid& grid = grids[static_cast<std::size_t>(i)];
        struct Candidate {
            double share;
            double distance;
            int view;
        };
        std::vector<Candidate> candidates;
        for (std::size_t j = 0; j < grids.size(); ++j) {
            if (static_cast<int>(j) == i) continue;
            const double share = shared_sight(grid, grids[j]);
            const double distance =
                (centre_in_world(grid.cam_from_world) - centre_in_world(grids[j].cam_from_world))
                    .norm();
            if (share > 0) candidates.push_back({share, distance, static_cast<int>(j)});
        }
        std::sort(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
            return std::pair(-a.share, a.distance) < std::pair(-b.share, b.distance);
        });
        candidates.resize(std::min(candidates.size(), kPartners));
        for (const Candidate& candidate : candidates) {
            partners[static_cast<std::size_t>(i)].push_back(candidate.view);
        }
    });
    std::set<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < partners.size(); ++i) {
        for (const int j : partners[i]) pairs.insert(std::minmax(static_cast<int>(i), j));
    }
    return {pairs.begin(), pairs.end()};
}

/// The light at a place between cells; empty where one of the four around it says nothing.
std::optional<Eigen::Vector3f> light_at(const Image<Eigen::Vector3f>& light,
                                        const Eigen::Vector2d& place) {
    const int x = std::min(static_cast<int>(place.x() - 0.5), light.width() - 2);
    const int y = std::min(static_cast<int>(place.y() - 0.5), light.height() - 2);
    if (x < 0 || y < 0) return std::nullopt;
    const auto right = static_cast<float>(place.x() - 0.5 - x);
    const auto down = static_cast<float>(place.y() - 0.5 - y);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (int i = 0; i < 4; ++i) {
        const Eigen::Vector3f& corner = light(x + i % 2, y + i / 2);
        if (corner.x() < 0) return std::nullopt;
        sum += (i % 2 == 1 ? right : 1 - right) * (i / 2 == 1 ? down : 1 - down) * corner;
    }
    return sum;
}

/// Whether the surface that the second view has at a place is the one the first has at its cell.
bool is_same_surface(const LightGrid& second, const RoundTrip& trip, const Eigen::Vector2d& place,
                     int x, int y) {
    const float inverse_depth =
        second.inverse_depth(static_cast<int>(place.x()), static_cast<int>(place.y()));
    if (inverse_depth < 0) return false;
    const auto returned =
        trip.returned({x + 0.5, y + 0.5}, place, static_cast<double>(inverse_depth));
    return returned && returned->error_px < kSameSurfaceCells;
}

/// What the cells of a tile say.
struct TileSamples {
    std::vector<Eigen::Vector3d> log_ratios;
    std::vector<double> levers;
};

/// By column and row of the tiles of the first picture.
using SamplesOfTiles = std::map<std::pair<int, int>, TileSamples>;

SamplesOfTiles samples_of(const LightGrid& first, const LightGrid& second) {
    const RoundTrip trip = round_trip(first, second);
    SamplesOfTiles tiles;
    for (int y = 0; y < first.light.height(); ++y) {
        for (int x = 0; x < first.light.width(); ++x) {
            const float inverse_depth = first.inverse_depth(x, y);
            const Eigen::Vector3f& own = first.light(x, y);
            if (inverse_depth < 0 || own.x() < 0) continue;
            const auto place =
                place_in(second, trip.there, x, y, static_cast<double>(inverse_depth));
            if (!place || !is_same_surface(second, trip, *place, x, y)) continue;
            const auto other = light_at(second.light, *place);
            if (!other) continue;
            TileSamples& tile = tiles[{x / kTile, y / kTile}];
            tile.log_ratios.push_back((other->array() / own.array()).log().matrix().cast<double>());
            tile.levers.push_back(squared_tangent(second.camera, *place) -
                                  squared_tangent(first.camera, {x + 0.5, y + 0.5}));
        }
    }
    return tiles;
}

/// The views on coarse rasters.
struct LightGrids {
    std::vector<LightGrid> colored;
    std::vector<LightGrid> colorless;  ///< The same in black and white; empty where none needs it.
    std::vector<char> have_color;      ///< All, where no photograph has.

    [[nodiscard]] bool have_color_both(std::size_t first, std::size_t second) const {
        return have_color[first] != 0 && have_color[second] != 0;
    }
};

LightGrids grids_of(const std::vector<PicturedView>& views, int threads, const Progress& progress) {
    LightGrids grids;
    grids.colored.resize(views.size());
    grids.have_color.resize(views.size());
    const auto for_each_view = [&](const auto& work) {
        parallel_for(static_cast<int>(views.size()), threads, [&](int i) {
            progress.throw_if_interrupted();
            work(static_cast<std::size_t>(i));
        });
    };
    for_each_view([&](std::size_t i) {
        grids.colored[i] = grid_of(views[i], *views[i].photograph);
        grids.have_color[i] = has_color(*views[i].photograph) ? 1 : 0;
    });
    const auto colored = std::count(grids.have_color.begin(), grids.have_color.end(), 1);
    if (colored == 0) grids.have_color.assign(views.size(), 1);
    if (colored == 0 || colored == static_cast<std::ptrdiff_t>(views.size())) return grids;
    grids.colorless.resize(views.size());
    for_each_view([&](std::size_t i) {
        grids.colorless[i] = grid_of(views[i], without_color(*views[i].photograph));
    });
    return grids;
}

std::vector<SharedTile> tiles_of(const LightGrid& first, const LightGrid& second) {
    std::vector<SharedTile> tiles;
    for (const auto& [tile, samples] : samples_of(first, second)) {
        if (samples.levers.size() < kLeastSamples) continue;
        tiles.push_back({static_cast<std::size_t>((tile.first + tile.second) % 2),
                         channelwise_median(samples.log_ratios), mean_of(samples.levers)});
    }
    return tiles;
}

}  // namespace

Eigen::Vector3d channelwise_median(const std::vector<Eigen::Vector3d>& samples) {
    Eigen::Vector3d median;
    for (Eigen::Index channel = 0; channel < 3; ++channel) {
        std::vector<double> values;
        for (const Eigen::Vector3d& sample : samples) values.push_back(sample[channel]);
        median[channel] = median_of(values);
    }
    return median;
}

std::vector<SharedTiles> shared_tiles(const std::vector<PicturedView>& views, int threads,
                                      const Progress& progress) {
    const LightGrids grids = grids_of(views, threads, progress);
    const std::vector<std::pair<int, int>> pairs = partners_of_all(grids.colored, threads);
    std::vector<SharedTiles> shared(pairs.size());
    parallel_for(static_cast<int>(pairs.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto& [first, second] = pairs[static_cast<std::size_t>(i)];
        const auto one = static_cast<std::size_t>(first);
        const auto other = static_cast<std::size_t>(second);
        const bool have_color = grids.have_color_both(one, other);
        const std::vector<LightGrid>& compared = have_color ? grids.colored : grids.colorless;
        shared[static_cast<std::size_t>(i)] = {
            first, second, tiles_of(compared[one], compared[other]), have_color};
    });
    return shared;
}

}  // namespace lumi
