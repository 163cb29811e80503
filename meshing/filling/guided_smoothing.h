#pragma once

#include "calib/capture/image.h"

namespace lumi {

struct GuidedSmoothing {
    double lambda = 100.0;  ///< Strength; pixels of reach grow with its root.
    double sigma = 3.0;     ///< Difference of the guide at which smoothing has fallen to 1/e.
    int iterations = 3;
};

/// Smooths `values`, each held by its weight (>= 0), along the edges of a guide of the same size:
/// minimises the weighted squared change of the values and the squared difference of neighbours,
/// the latter scaled by the guide. Fast Global Smoother (Min et al. 2014): exact solutions by rows
/// and columns in turn. Differences of the guide are the largest over the three colours. Where no
/// weight reaches, the value stays.
///
/// Ours rather than OpenCV's, whose last bits depend on how many threads are busy.
[[nodiscard]] FloatImage smooth_guided(const FloatImage& values, const FloatImage& weights,
                                       const ColorImage& guide, const GuidedSmoothing& options);

}  // namespace lumi
