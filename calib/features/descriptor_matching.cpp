#include "calib/features/descriptor_matching.h"

#include <algorithm>
#include <cmath>

#include "calib/features/nearest_descriptors.h"

namespace lumi {
namespace {

double angle_rad(std::uint32_t similarity) {
    constexpr double kOne = 512.0 * 512.0;
    return std::acos(std::min(similarity / kOne, 1.0));
}

bool is_distinct(const NearestDescriptors& nearest, const DescriptorMatchingOptions& options) {
    const double best = angle_rad(nearest.best);
    return best <= options.max_angle_rad && best < options.max_ratio * angle_rad(nearest.second);
}

}  // namespace

std::vector<FeatureMatch> match_descriptors(std::span<const Descriptor> first,
                                            std::span<const Descriptor> second,
                                            const DescriptorMatchingOptions& options) {
    static const DescriptorInstructions fastest = descriptor_instructions_here().back();
    const NearestBothWays nearest = nearest_descriptors(first, second, fastest);
    std::vector<FeatureMatch> matches;
    for (std::size_t index = 0; index < first.size(); ++index) {
        const NearestDescriptors& there = nearest.of_first[index];
        if (there.best == 0) continue;
        const NearestDescriptors& back = nearest.of_second[there.index];
        if (back.index == index && is_distinct(there, options) && is_distinct(back, options)) {
            matches.push_back({static_cast<std::uint32_t>(index), there.index});
        }
    }
    return matches;
}

}  // namespace lumi
