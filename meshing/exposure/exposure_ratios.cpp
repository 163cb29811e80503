#include "meshing/exposure/exposure_ratios.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "calib/work/median.h"

namespace lumi {
namespace {

constexpr std::size_t kLeastTiles = 3;

/// Of tiles about the value that stands for them.
double spread_of(const std::array<std::vector<Eigen::Vector3d>, 2>& fields,
                 const Eigen::Vector3d& middle) {
    std::vector<double> deviations;
    for (const auto& field : fields) {
        for (const Eigen::Vector3d& tile : field) {
            for (const double deviation : tile - middle) deviations.push_back(std::abs(deviation));
        }
    }
    return kSigmaPerMedianOff * median_of(deviations);
}

std::optional<ExposureRatio> ratio_of(const SharedTiles& pair, double light_falloff) {
    std::array<std::vector<Eigen::Vector3d>, 2> fields;
    for (const SharedTile& tile : pair.tiles) {
        fields[tile.fold].emplace_back(tile.log_ratio.array() - light_falloff * tile.lever);
    }
    if (std::min(fields[0].size(), fields[1].size()) < kLeastTiles) return std::nullopt;
    ExposureRatio ratio{pair.first, pair.second};
    ratio.log_ratio = {channelwise_median(fields[0]), channelwise_median(fields[1])};
    ratio.spread = spread_of(fields, 0.5 * (ratio.log_ratio[0] + ratio.log_ratio[1]));
    ratio.tiles = std::move(fields);
    ratio.tells_white_balance = pair.tell_white_balance;
    return ratio;
}

}  // namespace

std::vector<ExposureRatio> exposure_ratios(const std::vector<SharedTiles>& pairs,
                                           double light_falloff) {
    std::vector<ExposureRatio> ratios;
    for (const SharedTiles& pair : pairs) {
        if (const auto ratio = ratio_of(pair, light_falloff)) ratios.push_back(*ratio);
    }
    return ratios;
}

}  // namespace lumi
