#include "pipeline/chart/chart_result.h"

#include <algorithm>

#include "calib/work/median.h"

namespace lumi {
namespace {

const ScoreMetric& metric_named(const std::string& name) {
    return *std::find_if(score_metrics().begin(), score_metrics().end(),
                         [&](const ScoreMetric& metric) { return name == metric.name; });
}

}  // namespace

double build_cpu_s(const MeasuredVariant& variant) {
    double sum = 0.0;
    for (const StageTimes& stage : variant.stages) sum += median_of(stage.cpu_s);
    return sum;
}

double build_wall_s(const MeasuredVariant& variant) {
    double sum = 0.0;
    for (const StageTimes& stage : variant.stages) sum += median_of(stage.wall_s);
    return sum;
}

std::vector<ChartPoint> points_of(const ChartResult& result) {
    std::vector<ChartPoint> points;
    for (std::size_t i = 0; i < result.variants.size(); ++i) {
        const MeasuredVariant& variant = result.variants[i];
        for (const ModeScores& scores : variant.scores) {
            ChartPoint point;
            point.variant = i;
            point.mode = scores.mode;
            point.label = result.sweep.variants[i].label + ' ' + name_of(scores.mode);
            point.build_cpu_s = build_cpu_s(variant);
            point.build_wall_s = build_wall_s(variant);
            point.package_mib = variant.package_mib;
            point.mean = mean_score(scores.views);
            point.frame_ms = point.mean.ms;
            point.flip_interval = interval_of(metric_named("flip"), scores.views);
            point.psnr_interval = interval_of(metric_named("psnr_db"), scores.views);
            points.push_back(std::move(point));
        }
    }
    return points;
}

}  // namespace lumi
