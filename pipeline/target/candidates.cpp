#include "pipeline/target/candidates.h"

#include <algorithm>

namespace lumi {

Achievement achievement_of(const ChartPoint& point) {
    return {point.frame_ms > 0.0 ? 1000.0 / point.frame_ms : 0.0, point.mean.psnr_db,
            point.package_mib, point.build_wall_s};
}

std::vector<ChartPoint> candidates_for(const Wish& wish, std::vector<ChartPoint> points) {
    const auto is_better = [&](const ChartPoint& a, const ChartPoint& b) {
        if (wish.kind == Wish::Kind::kPsnrDb) return a.build_cpu_s < b.build_cpu_s;
        return a.mean.flip < b.mean.flip;
    };
    std::stable_sort(points.begin(), points.end(), [&](const ChartPoint& a, const ChartPoint& b) {
        const double missing_a = shortfall(wish, achievement_of(a));
        const double missing_b = shortfall(wish, achievement_of(b));
        if (missing_a != missing_b) return missing_a < missing_b;
        return missing_a == 0.0 && is_better(a, b);
    });
    return points;
}

}  // namespace lumi
