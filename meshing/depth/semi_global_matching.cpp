#include "meshing/depth/semi_global_matching.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include "meshing/depth/instruction_sets.h"
#include "meshing/depth/path_cost.h"

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
          start_(static_cast<std::size_t>(volume.max_count()) + 2, 0),
          aligned_(static_cast<std::size_t>(volume.max_count()) + 2, kUnreachable) {}

    /// `step` is +1 from the top-left corner, -1 from the bottom-right one.
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
                const int x = x_begin + step * column;
                advance(along, along, x, y, x - step, y);
                for (int d = 0; d < 3; ++d) {
                    const auto direction = static_cast<std::size_t>(d);
                    advance(previous[direction], current[direction], x, y, x + d - 1, y - step);
                }
            }
            std::swap(previous, current);
        }
    }

 private:
    /// Extends the path that comes from (from_x, from_y) to (x, y).
    void advance(PathRow& from, PathRow& to, int x, int y, int from_x, int from_y) {
        const int count = volume_.tile(x, y).count;
        const std::size_t offset = volume_.offset(x, y);
        const std::uint8_t* previous = start_.data() + 1;
        std::uint8_t previous_min = 0;
        std::uint8_t p2 = p1_;
        if (gray_.contains(from_x, from_y)) {
            previous = aligned(from.at(from_x), from_x, from_y, x, y);
            previous_min = from.minimum(from_x);
            p2 = p2_[static_cast<std::size_t>(std::abs(gray_(x, y) - gray_(from_x, from_y)))];
        }
        std::uint8_t* current = to.at(x);
        current[count] = kUnreachable;
        to.minimum(x) = advance_path(volume_.costs().data() + offset, previous, previous_min, p1_,
                                     p2, count, current, sums_.data() + offset);
    }

    /// The previous pixel's path costs by the planes of (x, y): index for index within a tile,
    /// whose planes slope with it, and shifted across the border of two tiles.
    const std::uint8_t* aligned(const std::uint8_t* costs, int from_x, int from_y, int x, int y) {
        const TilePlanes& from = volume_.tile(from_x, from_y);
        const TilePlanes& to = volume_.tile(x, y);
        if (&from == &to) return costs;
        const Eigen::Vector2d slope = 0.5 * (from.slope + to.slope);
        const double continued = volume_.first_plane(from_x, from_y) +
                                 slope.dot(Eigen::Vector2d(x - from_x, y - from_y));
        const int shift = static_cast<int>(std::lround(volume_.first_plane(x, y) - continued));
        if (shift == 0 && from.count == to.count) return costs;
        std::fill(aligned_.begin(), aligned_.end(), kUnreachable);
        const int begin = std::max(-1, -shift);
        const int end = std::min(to.count + 1, from.count - shift);
        for (int k = begin; k < end; ++k) {
            aligned_[static_cast<std::size_t>(k + 1)] = costs[k + shift];
        }
        return aligned_.data() + 1;
    }

    const CostVolume& volume_;
    const GrayImage& gray_;
    std::uint8_t p1_;
    PenaltyTable p2_;
    std::vector<std::uint16_t>& sums_;
    std::vector<std::uint8_t> start_;  ///< A path begins as if the pixel before it cost nothing.
    std::vector<std::uint8_t> aligned_;
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
    sums.assign(volume.costs().size(), 0);
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
