#include "meshing/agreement/cross_view_check.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "meshing/surface/depth_map.h"
#include "meshing/warp/parallax.h"
#include "meshing/warp/round_trip.h"

namespace lumi {
namespace {

constexpr double kMaxDisagreementPx = 1.0;
constexpr double kMaxOfFastestPx = 2.0;  // The same, as the fastest neighbour would see it.
constexpr double kMaxStepPx = 4.0;       // Disparity between neighbouring pixels of a steep floor.

/// A neighbour that is asked whether it agrees.
struct AskedNeighbour {
    const DepthMap* map;
    RoundTrip trip;
    double max_step_there;  ///< Inverse depth by which pixels of one surface differ at most.
    double max_disagreement_px;
};

/// Inverse depth at a pixel of a map: bilinear on one surface, the nearest pixel's at a jump. Empty
/// outside the map and where the map does not claim to know.
std::optional<double> sample(const DepthMap& map, const Eigen::Vector2d& pixel, double max_step) {
    const bool is_inside = pixel.x() >= 0 && pixel.x() < map.confidence.width() && pixel.y() >= 0 &&
                           pixel.y() < map.confidence.height();
    if (!is_inside) return std::nullopt;
    const int nearest_x = static_cast<int>(pixel.x());
    const int nearest_y = static_cast<int>(pixel.y());
    if (map.confidence(nearest_x, nearest_y) == 0) return std::nullopt;
    const double nearest = static_cast<double>(map.inverse_depth(nearest_x, nearest_y));
    const int x = static_cast<int>(pixel.x() + 0.5) - 1;  // Of the pixel to the upper left.
    const int y = static_cast<int>(pixel.y() + 0.5) - 1;
    if (x < 0 || y < 0 || !map.confidence.contains(x + 1, y + 1)) return nearest;
    const double right = pixel.x() - 0.5 - x;
    const double down = pixel.y() - 0.5 - y;
    double mean = 0;
    for (int corner = 0; corner < 4; ++corner) {
        const int dx = corner % 2;
        const int dy = corner / 2;
        const double value = static_cast<double>(map.inverse_depth(x + dx, y + dy));
        if (std::abs(value - nearest) > max_step) return nearest;
        mean += value * (dx == 1 ? right : 1 - right) * (dy == 1 ? down : 1 - down);
    }
    return mean;
}

/// What the neighbour says of this pixel, as inverse depth here; empty unless it agrees.
std::optional<double> confirmation(const AskedNeighbour& asked, const Eigen::Vector2d& pixel,
                                   double inverse_depth) {
    const auto there = asked.trip.there.at(pixel, inverse_depth);
    if (!there) return std::nullopt;
    const auto found = sample(*asked.map, there->pixel, asked.max_step_there);
    if (!found) return std::nullopt;
    const auto returned = asked.trip.returned(pixel, there->pixel, *found);
    if (!returned || returned->error_px > asked.max_disagreement_px) return std::nullopt;
    return returned->inverse_depth;
}

/// Of each of a view's neighbours, as a share of the fastest one's.
std::vector<double> parallax_shares(const DepthScene& scene, const DepthView& view) {
    std::vector<double> shares;
    double fastest = 0.0;
    for (const int j : view.neighbours) {
        shares.push_back(
            disparity_px_per_inverse_depth(view, scene.views[static_cast<std::size_t>(j)]));
        fastest = std::max(fastest, shares.back());
    }
    for (double& share : shares) share = fastest > 0 ? share / fastest : 0.0;
    return shares;
}

std::vector<AskedNeighbour> asked_neighbours(const DepthScene& scene,
                                             const std::vector<DepthEstimate>& estimates,
                                             const DepthView& view) {
    std::vector<AskedNeighbour> neighbours;
    const std::vector<double> shares = parallax_shares(scene, view);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        const auto index = static_cast<std::size_t>(view.neighbours[k]);
        const DepthView& other = scene.views[index];
        if (!estimates[index].needs_confirmation) continue;  // Not found from the photographs.
        if (shares[k] < kLeastParallaxShare) continue;
        neighbours.push_back({&estimates[index].map, round_trip(view, other),
                              kMaxStepPx / other.disparity_px_per_inverse_depth,
                              std::min(kMaxDisagreementPx, kMaxOfFastestPx * shares[k])});
    }
    return neighbours;
}

/// Pixels of the patch around `start`, flooded by confidence and nearness in inverse depth.
void flood(const DepthMap& map, int start, double max_step, std::vector<char>& visited,
           std::vector<int>& patch) {
    const int width = map.inverse_depth.width();
    patch.assign(1, start);
    visited[static_cast<std::size_t>(start)] = 1;
    for (std::size_t next = 0; next < patch.size(); ++next) {
        const int x = patch[next] % width;
        const int y = patch[next] / width;
        const double own = static_cast<double>(map.inverse_depth(x, y));
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
            if (!map.confidence.contains(x + dx, y + dy)) continue;
            const int other = (y + dy) * width + x + dx;
            if (visited[static_cast<std::size_t>(other)] != 0) continue;
            if (map.confidence(x + dx, y + dy) == 0) continue;
            const double step = static_cast<double>(map.inverse_depth(x + dx, y + dy)) - own;
            if (std::abs(step) > max_step) continue;
            visited[static_cast<std::size_t>(other)] = 1;
            patch.push_back(other);
        }
    }
}

}  // namespace

DepthMap cross_view_check(const DepthScene& scene, const std::vector<DepthEstimate>& estimates,
                          int view_index) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    const std::vector<AskedNeighbour> neighbours = asked_neighbours(scene, estimates, view);
    DepthMap map = estimates[static_cast<std::size_t>(view_index)].map;
    for (int y = 0; y < map.inverse_depth.height(); ++y) {
        for (int x = 0; x < map.inverse_depth.width(); ++x) {
            if (map.confidence(x, y) == 0) continue;
            const double own = static_cast<double>(map.inverse_depth(x, y));
            double sum = own;
            int agreeing = 0;
            for (const AskedNeighbour& neighbour : neighbours) {
                const auto said = confirmation(neighbour, {x + 0.5, y + 0.5}, own);
                if (!said) continue;
                sum += *said;
                ++agreeing;
            }
            map.inverse_depth(x, y) = static_cast<float>(sum / (1 + agreeing));
            map.confidence(x, y) = confidence_of_support(agreeing);
        }
    }
    return map;
}

void remove_speckles(DepthMap& map, double max_step, int min_pixels) {
    const int pixels = static_cast<int>(map.confidence.pixels().size());
    std::vector<char> visited(static_cast<std::size_t>(pixels), 0);
    std::vector<int> patch;
    for (int start = 0; start < pixels; ++start) {
        const auto index = static_cast<std::size_t>(start);
        if (visited[index] != 0 || map.confidence.pixels()[index] == 0) continue;
        flood(map, start, max_step, visited, patch);
        if (static_cast<int>(patch.size()) >= min_pixels) continue;
        for (const int pixel : patch) map.confidence.pixels()[static_cast<std::size_t>(pixel)] = 0;
    }
}

}  // namespace lumi
