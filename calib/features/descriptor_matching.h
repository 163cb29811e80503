#pragma once

#include <span>
#include <vector>

#include "calib/features/features.h"

namespace lumi {

struct DescriptorMatchingOptions {
    double max_ratio = 0.8;      ///< Angle to the nearest over angle to the second. (0, 1].
    double max_angle_rad = 0.7;  ///< Between the descriptors of a match. > 0.
};

/// Mutual nearest neighbours that pass the ratio test in both directions (Lowe 2004, section 7.1),
/// found by comparing all with all in exact integer arithmetic: the same on every machine. Ordered
/// by the first index.
[[nodiscard]] std::vector<FeatureMatch> match_descriptors(std::span<const Descriptor> first,
                                                          std::span<const Descriptor> second,
                                                          const DescriptorMatchingOptions& options);

}  // namespace lumi
