#include "meshing/exposure/gains_among_neighbours.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace lumi {
namespace {

constexpr std::size_t kNeighbours = 4;
constexpr double kLargestNeighbourLog =
    2.77;  // Four stops: beyond that nothing is left to even out.

using Logs = std::array<double, 3>;

/// Of a view and those nearest to it, itself first.
std::vector<std::size_t> views_around(std::size_t view,
                                      const std::vector<Eigen::Vector3d>& centres_in_world) {
    std::vector<std::pair<double, std::size_t>> around;
    for (std::size_t j = 0; j < centres_in_world.size(); ++j) {
        around.emplace_back((centres_in_world[view] - centres_in_world[j]).squaredNorm(), j);
    }
    const std::size_t count = std::min(around.size(), 1 + kNeighbours);
    std::partial_sort(around.begin(), around.begin() + static_cast<std::ptrdiff_t>(count),
                      around.end());
    std::vector<std::size_t> views;
    for (std::size_t k = 0; k < count; ++k) views.push_back(around[k].second);
    return views;
}

double mean_over_channels(const Logs& logs) { return (logs[0] + logs[1] + logs[2]) / 3; }

/// The mean of the logarithms. What channels differ by is that of the views that tell it.
Logs mean_log(const std::vector<std::size_t>& views,
              const std::vector<std::array<double, 3>>& gains,
              const std::vector<char>& tell_white_balance) {
    Logs sum{};
    double of_others = 0;
    std::size_t telling = 0;
    for (const std::size_t view : views) {
        Logs logs;
        for (std::size_t channel = 0; channel < 3; ++channel)
            logs[channel] = std::log(gains[view][channel]);
        if (tell_white_balance[view] == 0) {
            of_others += mean_over_channels(logs);
            continue;
        }
        ++telling;
        for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += logs[channel];
    }
    const auto count = static_cast<double>(views.size());
    if (telling == views.size()) return {sum[0] / count, sum[1] / count, sum[2] / count};
    const double common = mean_over_channels(sum);
    Logs mean{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        mean[channel] = (common + of_others) / count;
        if (telling > 0) mean[channel] += (sum[channel] - common) / static_cast<double>(telling);
    }
    return mean;
}

}  // namespace

std::vector<std::array<double, 3>> gains_among_neighbours(
    const std::vector<std::array<double, 3>>& gains, const std::vector<char>& tell_white_balance,
    const std::vector<Eigen::Vector3d>& centres_in_world) {
    std::vector<std::array<double, 3>> result = gains;
    for (std::size_t i = 0; i < gains.size(); ++i) {
        Logs mean = mean_log(views_around(i, centres_in_world), gains, tell_white_balance);
        if (tell_white_balance[i] == 0) mean.fill(mean_over_channels(mean));
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double log = std::log(gains[i][channel]) - mean[channel];
            result[i][channel] = std::exp(std::clamp(log, -kLargestNeighbourLog, kLargestLog));
        }
    }
    return result;
}

}  // namespace lumi
