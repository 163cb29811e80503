#pragma once

#include <functional>
#include <vector>

#include "meshing/cameras/scene_centre.h"

namespace lumi {

/// How far two cameras are apart as one sees a scene from them: the angle between their directions
/// from `centre`, and half the logarithm of the ratio of their distances.
[[nodiscard]] double viewpoint_distance(const OpticalAxis& a, const OpticalAxis& b,
                                        const Eigen::Vector3d& centre);

/// `count` of the cameras that stand for all of them best: no camera is far from a chosen one. The
/// farthest camera is added again and again (Gonzalez 1985), beginning at the middle one, so that
/// near-duplicates go first; then each chosen camera moves to the middle of those nearest to it
/// (k-medoids) while the mean squared distance falls. Indices into `axes`, ascending.
[[nodiscard]] std::vector<int> representative_views(const std::vector<OpticalAxis>& axes,
                                                    const Eigen::Vector3d& centre, int count);

/// What a choice of views costs at each held-out place; the same places in the same order each
/// time.
using HeldOutLosses = std::function<std::vector<double>(const std::vector<int>& views)>;

/// One choice on the way from all views to few.
struct ViewChoice {
    std::vector<int> views;
    std::vector<double> losses;
    double mean_loss = 0.0;
    double mean_excess = 0.0;     ///< Over the choice with the least loss.
    double standard_error = 0.0;  ///< Of that difference, over the held-out places.
};

struct ViewSelection {
    std::vector<ViewChoice> curve;  ///< All views first, then ever fewer.
    std::size_t chosen = 0;
};

/// Numbers of views to try: all, then each time a quarter less, down to `least`.
[[nodiscard]] std::vector<int> selection_sizes(int views, int least);

/// Tries representative views in each of the sizes and chooses the fewest whose loss cannot be told
/// from the least: by the one-standard-error rule (Breiman et al. 1984), on differences at the same
/// held-out places. `sizes` must not be empty.
[[nodiscard]] ViewSelection select_views(const std::vector<OpticalAxis>& axes,
                                         const Eigen::Vector3d& centre,
                                         const std::vector<int>& sizes,
                                         const HeldOutLosses& losses_of);

}  // namespace lumi
