#include <algorithm>
#include <cmath>
#include <numeric>

#include "pipeline/protocol/view_subset.h"
#include "pipeline/stress/perturbation.h"
#include "pipeline/stress/seeded_normal.h"

namespace lumi {

Lumigraph with_views_dropped(const Lumigraph& lumigraph, double percent, std::uint64_t seed,
                             const CameraMeshOptions& mesh_options) {
    const SeededNormal random(seed);
    std::vector<int> order(lumigraph.views.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return random.uniform(static_cast<std::uint64_t>(a), 0) <
               random.uniform(static_cast<std::uint64_t>(b), 0);
    });
    const auto count = static_cast<double>(order.size());
    const auto dropped =
        static_cast<std::size_t>(std::clamp(std::round(count * percent / 100.0), 0.0, count - 1.0));
    std::vector<int> kept(order.begin() + static_cast<std::ptrdiff_t>(dropped), order.end());
    std::sort(kept.begin(), kept.end());
    return only_these_views(lumigraph, kept, mesh_options);
}

}  // namespace lumi
