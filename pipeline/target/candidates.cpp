#include "pipeline/target/candidates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "meshing/depth_models/depth_model.h"
#include "pipeline/chart/default_sweep.h"

namespace lumi {
namespace {

/// Of the working copies: photographs are never enlarged, and frames of a video that are taken as
/// they are count as larger than any that are scaled down.
double copies_side_px(const BuildConfig& config, int photographs_side_px) {
    constexpr double kBeyondAnyVideo_px = 1e5;
    const int asked_px = config.ingest.max_width_px;
    const double side_px = asked_px > 0 ? asked_px : kBeyondAnyVideo_px;
    return photographs_side_px > 0 ? std::min(side_px, static_cast<double>(photographs_side_px))
                                   : side_px;
}

/// Each model of the ladder is taken for twice as dear as the one below ("auto" for the highest
/// that it climbs to), and the poses for as dear as a sweep.
double expected_cost(const BuildConfig& config, int photographs_side_px) {
    constexpr double kPoses = 30;
    constexpr double kDearer = 2;
    const std::vector<std::string>& ladder = depth_model_names();
    const std::string model = config.depth.model == "auto" ? "refined_sweep" : config.depth.model;
    const auto rung = std::find(ladder.begin(), ladder.end(), model) - ladder.begin();
    const double side_px = copies_side_px(config, photographs_side_px);
    return side_px * side_px * (kPoses + std::pow(kDearer, static_cast<double>(rung)));
}

}  // namespace

Achievement achievement_of(const ChartPoint& point) {
    return {point.frame_ms > 0.0 ? 1000.0 / point.frame_ms : 0.0, point.mean.psnr_db,
            point.package_mib, point.build_wall_s};
}

std::vector<ChartPoint> candidates_for(const Wish& wish, std::vector<ChartPoint> points) {
    const auto is_better = [&](const ChartPoint& a, const ChartPoint& b) {
        if (wish.kind == Wish::Kind::kPsnrDb) return a.build_cpu_s < b.build_cpu_s;
        return a.mean.flip < b.mean.flip;
    };
    constexpr double kMostOfIt = 0.9;
    double most_covered = 0.0;
    for (const ChartPoint& point : points) {
        most_covered = std::max(most_covered, point.mean.coverage);
    }
    const auto shows_little = [&](const ChartPoint& point) {
        return point.mean.coverage < kMostOfIt * most_covered;
    };
    std::stable_sort(points.begin(), points.end(), [&](const ChartPoint& a, const ChartPoint& b) {
        if (shows_little(a) != shows_little(b)) return shows_little(b);
        const double missing_a = shortfall(wish, achievement_of(a));
        const double missing_b = shortfall(wish, achievement_of(b));
        if (missing_a != missing_b) return missing_a < missing_b;
        return missing_a == 0.0 && is_better(a, b);
    });
    return points;
}

void put_cheapest_first(Sweep& sweep) {
    std::map<std::filesystem::path, int> side_px_of;
    std::vector<std::pair<double, Variant>> priced;
    for (Variant& variant : sweep.variants) {
        const std::filesystem::path& photographs = variant.config.photographs_or_video;
        if (!side_px_of.contains(photographs))
            side_px_of[photographs] = longest_side_px(photographs);
        const double cost = expected_cost(variant.config, side_px_of.at(photographs));
        priced.emplace_back(cost, std::move(variant));
    }
    std::stable_sort(priced.begin(), priced.end(),
                     [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < priced.size(); ++i) {
        sweep.variants[i] = std::move(priced[i].second);
    }
}

bool ends_the_sweep(const Wish& wish, const MeasuredVariant& variant) {
    constexpr double kSurelyTooLong = 1.5;  // The order goes by a rough expectation.
    if (wish.kind == Wish::Kind::kBuildSeconds) {
        return build_wall_s(variant) > kSurelyTooLong * wish.value;
    }
    if (wish.kind != Wish::Kind::kPsnrDb) return false;
    return std::any_of(variant.scores.begin(), variant.scores.end(), [&](const ModeScores& mode) {
        return meets(wish, {0.0, mean_score(mode.views).psnr_db, 0.0, 0.0});
    });
}

}  // namespace lumi
