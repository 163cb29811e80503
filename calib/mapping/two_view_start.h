#pragma once

#include <utility>
#include <vector>

#include "calib/mapping/growing_model.h"

namespace lumi {

struct TwoViewStartOptions {
    double min_angle_rad = 0.07;   ///< Of a point that speaks for a pair; 4 degrees. > 0.
    double full_angle_rad = 0.17;  ///< From here on a larger angle is no better; 10 degrees.
    int min_points = 40;           ///< Points that must speak for it. > 0.
    double max_error_px = 4.0;     ///< > 0.
};

/// Two photographs that a reconstruction can begin with.
struct TwoViewStart {
    int first = 0;
    int second = 0;
    Rigid3 second_from_first;  ///< Translation of length one.
    double weight = 0;         ///< Points, each as good as its angle.
};

/// The pairs to begin with, the best first: those with most points under a wide angle. What the
/// best rotation leaves of each pair's matches shows which have parallax; of the most promising, an
/// essential matrix tells how many points lie before both cameras (Nistér, PAMI 2004). Pairs with a
/// placed photograph are left out.
[[nodiscard]] std::vector<TwoViewStart> two_view_starts(const GrowingModel& model,
                                                        const std::vector<VerifiedPair>& pairs,
                                                        const TwoViewStartOptions& options);

}  // namespace lumi
