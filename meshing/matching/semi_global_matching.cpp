#include "meshing/matching/semi_global_matching.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "meshing/matching/path_cost.h"
#include "meshing/warp/instruction_sets.h"

namespace lumi {
namespace {

using PenaltyTable = std::array<std::uint8_t, 256>;

/// P2 for each grey difference.
PenaltyTable jump_penalties(const SmoothnessPenalty& penalty) {
    PenaltyTable table{};
    for (std::size_t difference = 0; difference < table.size(); ++difference) {
        const double share = std::exp(-static_cast<double>(difference) / penalty.edge_gray);
        table[difference] = static_cast<std::uint8_t>(
            std::lround(penalty.jump_at_edge + share * (penalty.jump - penalty.jump_at_edge)));
    }
    return table;
}

/// Path costs of one row of pixels along one direction.
class PathRow {
 public:
    PathRow(int width, int max_count)
        : stride_(static_cast<std::size_t>(max_count) + 2),
          values_(static_cast<std::size_t>(width) * stride_, kUnreachable),
          minima_(static_cast<std::size_t>(width), 0) {}

    [[nodiscard]] std::uint8_t* at(int x) {
        return values_.data() + static_cast<std::size_t>(x) * stride_ + 1;
    }
    [[nodiscard]] std::uint8_t& minimum(int x) { return minima_[static_cast<std::size_t>(x)]; }

 private:
    std::size_t stride_;
    std::vector<std::uint8_t> values_;
    std::vector<std::uint8_t> minima_;
};

/// One sweep over the picture, forwards or backwards: four of the eight directions.
class PathSweep {
 public:
    PathSweep(const CostVolume& volume, const GrayImage& gray, const SmoothnessPenalty& penalty,
              std::vector<std::uint16_t>& sums)
        : volume_(volume),
          gray_(gray),
          p1_(static_cast<std::uint8_t>(penalty.one_plane)),
          p2_(jump_penalties(penalty)),
          sums_(sums),
          start_(static_cast<std::size_t>(volume.max_count()) + 2, 0) {
        aligned_.fill(std::vector<std::uint8_t>(static_cast<std::size_t>(volume.max_count()) + 2));
    }

    /// `step` is +1 from the top-left corner, which writes the sums, and then -1 from the
    /// bottom-right one, which adds to them.
    void run(int step) {
        const int width = volume_.width();
        const int height = volume_.height();
        PathRow along(width, volume_.max_count());
        std::vector<PathRow> previous(3, along);
        std::vector<PathRow> current(3, along);
        const int x_begin = step > 0 ? 0 : width - 1;
        for (int row = 0; row < height; ++row) {
            const int y = step > 0 ? row : height - 1 - row;
            for (int column = 0; column < width; ++column) {
                advance(along, previous, current, x_begin + step * column, y, step);
            }
            std::swap(previous, current);
        }
    }

 private:
    /// Extends the path along the row and the three from the row before to (x, y).
    void advance(PathRow& along, std::vector<PathRow>& above, std::vector<PathRow>& own, int x,
                 int y, int step) {
        const TilePlanes& tile = volume_.tile(x, y);
        const std::size_t offset = volume_.offset(x, y);
        std::array<IncomingPath, kPathsAtOnce> paths;
        paths[0] = incoming(along, along, 0, x, y, x - step, y);
        for (int d = 0; d < 3; ++d) {
            const auto direction = static_cast<std::size_t>(d);
            paths[direction + 1] = incoming(above[direction], own[direction], direction + 1, x, y,
                                            x + d - 1, y - step);
        }
        std::array<std::uint8_t, kPathsAtOnce> minima;
        for (const IncomingPath& path : paths) path.current[tile.count] = kUnreachable;
        advance_paths(volume_.costs().data() + offset, paths.data(), p1_, tile.count, step < 0,
                      sums_.data() + offset, minima.data());
        along.minimum(x) = minima[0];
        for (std::size_t d = 0; d < 3; ++d) own[d].minimum(x) = minima[d + 1];
    }

    /// The path of row `from` that leads from (from_x, from_y) to (x, y) in row `to`.
    IncomingPath incoming(PathRow& from, PathRow& to, std::size_t direction, int x, int y,
                          int from_x, int from_y) {
        if (!gray_.contains(from_x, from_y)) return {start_.data() + 1, to.at(x), 0, p1_};
        const auto difference =
            static_cast<std::size_t>(std::abs(gray_(x, y) - gray_(from_x, from_y)));
        return {aligned(from.at(from_x), aligned_[direction], from_x, from_y, x, y), to.at(x),
                from.minimum(from_x), p2_[difference]};
    }

    /// The previous pixel's path costs by the planes of (x, y): index for index within a tile,
    /// whose planes slope with it, and shifted, into `shifted`, across the border of two tiles.
    const std::uint8_t* aligned(const std::uint8_t* costs, std::vector<std::uint8_t>& shifted,
                                int from_x, int from_y, int x, int y) const {
        const TilePlanes& from = volume_.tile(from_x, from_y);
        const TilePlanes& to = volume_.tile(x, y);
        if (&from == &to) return costs;
        const Eigen::Vector2d slope = 0.5 * (from.slope + to.slope);
        const double continued = volume_.first_plane(from_x, from_y) +
                                 slope.dot(Eigen::Vector2d(x - from_x, y - from_y));
        const int shift = static_cast<int>(std::lround(volume_.first_plane(x, y) - continued));
        if (shift == 0 && from.count == to.count) return costs;
        std::fill(shifted.begin(), shifted.end(), kUnreachable);
        const int begin = std::max(-1, -shift);
        const int end = std::min(to.count + 1, from.count - shift);
        for (int k = begin; k < end; ++k) {
            shifted[static_cast<std::size_t>(k + 1)] = costs[k + shift];
        }
        return shifted.data() + 1;
    }

    const CostVolume& volume_;
    const GrayImage& gray_;
    std::uint8_t p1_;
    PenaltyTable p2_;
    std::vector<std::uint16_t>& sums_;
    std::vector<std::uint8_t> start_;  ///< A path begins as if the pixel before it cost nothing.
    std::array<std::vector<std::uint8_t>, kPathsAtOnce> aligned_;  ///< One each path.
};

/// The smallest of some sums.
struct LeastSum {
    LUMI_KERNEL void run(const std::uint16_t* sums, int count, std::uint16_t* least) {
        std::uint16_t result = sums[0];
        for (int k = 0; k < count; ++k) result = sums[k] < result ? sums[k] : result;
        *least = result;
    }
};

/// Vertex of the parabola through three neighbouring sums, within half a plane.
float parabola_offset(int below, int best, int above) {
    const int curvature = below - 2 * best + above;
    if (curvature <= 0) return 0.0F;
    return std::clamp(static_cast<float>(below - above) / static_cast<float>(2 * curvature), -0.5F,
                      0.5F);
}

}  // namespace

void aggregate_paths(const CostVolume& volume, const GrayImage& gray,
                     const SmoothnessPenalty& penalty, std::vector<std::uint16_t>& sums) {
    assert(penalty.one_plane <= penalty.jump_at_edge && penalty.jump_at_edge <= penalty.jump);
    assert(kMaxMatchingCost + penalty.one_plane + penalty.jump < kUnreachable);
    assert(kUnreachable + penalty.one_plane <= 255);
    if (sums.capacity() < volume.costs().size()) std::vector<std::uint16_t>().swap(sums);
    sums.resize(volume.costs().size());
    PathSweep sweep(volume, gray, penalty, sums);
    sweep.run(+1);
    sweep.run(-1);
}

MatchedPlanes semi_global_matching(const CostVolume& volume, const GrayImage& gray,
                                   const SmoothnessPenalty& penalty,
                                   std::vector<std::uint16_t>& sums) {
    aggregate_paths(volume, gray, penalty, sums);
    MatchedPlanes result{FloatImage(volume.width(), volume.height()),
                         GrayImage(volume.width(), volume.height())};
    for (int y = 0; y < volume.height(); ++y) {
        for (int x = 0; x < volume.width(); ++x) {
            const int count = volume.tile(x, y).count;
            const std::uint16_t* sum = sums.data() + volume.offset(x, y);
            const std::uint8_t* cost = volume.costs().data() + volume.offset(x, y);
            std::uint16_t least = 0;
            run_fastest<LeastSum>(sum, count, &least);
            const auto best = static_cast<int>(std::find(sum, sum + count, least) - sum);
            float fraction = 0.0F;
            if (best > 0 && best + 1 < count) {
                fraction = parabola_offset(sum[best - 1], sum[best], sum[best + 1]);
            }
            result.plane(x, y) = static_cast<float>(volume.first_plane(x, y) + best) + fraction;
            result.cost(x, y) = cost[best];
        }
    }
    return result;
}

}  // namespace lumi
