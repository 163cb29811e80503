#include "pipeline/evaluate/view_score.h"

#include <algorithm>
#include <iterator>
#include <type_traits>

#include "calib/work/mean.h"

namespace lumi {

namespace {

template <auto kMember>
std::optional<double> value_of(const ViewScore& score) {
    return score.*kMember;
}

template <auto kMember>
constexpr bool kMayLack = std::is_same_v<decltype(kMember), std::optional<double> ViewScore::*>;

template <auto kMember>
void set_value(ViewScore& score, std::optional<double> value) {
    if constexpr (kMayLack<kMember>) {
        score.*kMember = value;
    } else {
        score.*kMember = value.value_or(0.0);
    }
}

template <auto kMember>
ScoreMetric metric_of(const char* name, bool higher_is_better, bool is_time = false) {
    return {name,   &value_of<kMember>, &set_value<kMember>, kMayLack<kMember>, higher_is_better,
            is_time};
}

}  // namespace

std::optional<double> psnr_but_for_exposure_db(const std::optional<double>& psnr_covered_db,
                                               const std::optional<double>& psnr_gain_fitted_db) {
    constexpr double kWorthTelling_db = 1.0;
    if (!psnr_covered_db || !psnr_gain_fitted_db ||
        *psnr_gain_fitted_db < *psnr_covered_db + kWorthTelling_db)
        return std::nullopt;
    return psnr_gain_fitted_db;
}

const std::vector<ScoreMetric>& score_metrics() {
    static const std::vector<ScoreMetric> metrics{
        metric_of<&ViewScore::psnr_db>("psnr_db", true),
        metric_of<&ViewScore::psnr_covered_db>("psnr_covered_db", true),
        metric_of<&ViewScore::ssim>("ssim", true),
        metric_of<&ViewScore::flip>("flip", false),
        metric_of<&ViewScore::flip_covered>("flip_covered", false),
        metric_of<&ViewScore::edge_sharpness>("edge_sharpness", true),
        metric_of<&ViewScore::psnr_gain_fitted_db>("psnr_gain_fitted_db", true),
        metric_of<&ViewScore::ghost_energy>("ghost_energy", false),
        metric_of<&ViewScore::psnr_subject_db>("psnr_subject_db", true),
        metric_of<&ViewScore::flip_subject>("flip_subject", false),
        metric_of<&ViewScore::subject_coverage>("subject_coverage", true),
        metric_of<&ViewScore::coverage>("coverage", true),
        metric_of<&ViewScore::ms>("ms", false, true),
        metric_of<&ViewScore::cpu_ms>("cpu_ms", false, true)};
    return metrics;
}

std::vector<double> values_of(const ScoreMetric& metric, const std::vector<ViewScore>& views) {
    std::vector<double> values;
    for (const ViewScore& view : views) {
        if (const auto value = metric.value(view)) values.push_back(*value);
    }
    return values;
}

std::optional<double> mean_of(const ScoreMetric& metric, const std::vector<ViewScore>& views) {
    const std::vector<double> values = values_of(metric, views);
    if (values.empty()) return std::nullopt;
    return mean_of(values);
}

std::optional<Interval> interval_of(const ScoreMetric& metric,
                                    const std::vector<ViewScore>& views) {
    return bootstrap_interval(values_of(metric, views));
}

std::optional<Interval> range_of(const ScoreMetric& metric, const std::vector<ViewScore>& views) {
    return range_of(values_of(metric, views));
}

ViewScore mean_score(const std::vector<ViewScore>& views) {
    ViewScore score;
    score.name = "mean";
    for (const ScoreMetric& metric : score_metrics()) metric.set(score, mean_of(metric, views));
    return score;
}

std::vector<ViewScore> views_at(ViewPlace place, const std::vector<ViewScore>& views) {
    std::vector<ViewScore> found;
    std::copy_if(views.begin(), views.end(), std::back_inserter(found),
                 [&](const ViewScore& view) { return view.place == place; });
    return found;
}

}  // namespace lumi
