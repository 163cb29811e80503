#include "meshing/depth/path_cost.h"

#include <algorithm>

#include "meshing/depth/vectorised.h"

namespace lumi {
namespace {

constexpr int kLanes = 16;  ///< Counts are multiples of this; fixed inner loops vectorise best.

}  // namespace

LUMI_VECTORISED
std::uint8_t advance_path(const std::uint8_t* __restrict cost,
                          const std::uint8_t* __restrict previous, std::uint8_t previous_min,
                          std::uint8_t p1, std::uint8_t p2, int count,
                          std::uint8_t* __restrict current, std::uint16_t* __restrict sum) {
    const auto jump = static_cast<std::uint8_t>(previous_min + p2);
    std::uint8_t lowest[kLanes];
    std::fill(lowest, lowest + kLanes, kUnreachable);
    for (int block = 0; block < count; block += kLanes) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const int k = block + lane;
            const auto below = static_cast<std::uint8_t>(previous[k - 1] + p1);
            const auto above = static_cast<std::uint8_t>(previous[k + 1] + p1);
            const std::uint8_t step = below < above ? below : above;
            const std::uint8_t stay = previous[k] < jump ? previous[k] : jump;
            const std::uint8_t best = step < stay ? step : stay;
            const auto total = static_cast<std::uint8_t>(cost[k] + best - previous_min);
            current[k] = total;
            sum[k] = static_cast<std::uint16_t>(sum[k] + total);
            lowest[lane] = total < lowest[lane] ? total : lowest[lane];
        }
    }
    return *std::min_element(lowest, lowest + kLanes);
}

}  // namespace lumi
