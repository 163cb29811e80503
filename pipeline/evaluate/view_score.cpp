#include "pipeline/evaluate/view_score.h"

#include <algorithm>
#include <iterator>

#include "calib/work/mean.h"

namespace lumi {

std::optional<double> psnr_but_for_exposure_db(const std::optional<double>& psnr_covered_db,
                                               const std::optional<double>& psnr_gain_fitted_db) {
    constexpr double kWorthTelling_db = 1.0;
    if (!psnr_covered_db || !psnr_gain_fitted_db ||
        *psnr_gain_fitted_db < *psnr_covered_db + kWorthTelling_db)
        return std::nullopt;
    return psnr_gain_fitted_db;
}

const std::vector<ScoreMetric>& score_metrics() {
    using Value = std::optional<double>;
    static const std::vector<ScoreMetric> metrics{
        {"psnr_db", [](const ViewScore& s) -> Value { return s.psnr_db; }, true},
        {"psnr_covered_db", [](const ViewScore& s) { return s.psnr_covered_db; }, true},
        {"ssim", [](const ViewScore& s) -> Value { return s.ssim; }, true},
        {"flip", [](const ViewScore& s) -> Value { return s.flip; }, false},
        {"flip_covered", [](const ViewScore& s) { return s.flip_covered; }, false},
        {"edge_sharpness", [](const ViewScore& s) { return s.edge_sharpness; }, true},
        {"psnr_gain_fitted_db", [](const ViewScore& s) { return s.psnr_gain_fitted_db; }, true},
        {"ghost_energy", [](const ViewScore& s) { return s.ghost_energy; }, false},
        {"psnr_subject_db", [](const ViewScore& s) { return s.psnr_subject_db; }, true},
        {"flip_subject", [](const ViewScore& s) { return s.flip_subject; }, false},
        {"subject_coverage", [](const ViewScore& s) { return s.subject_coverage; }, true},
        {"coverage", [](const ViewScore& s) -> Value { return s.coverage; }, true},
        {"ms", [](const ViewScore& s) -> Value { return s.ms; }, false, true},
        {"cpu_ms", [](const ViewScore& s) -> Value { return s.cpu_ms; }, false, true}};
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
    const auto mean = [&](const std::string& name) {
        const auto metric =
            std::find_if(score_metrics().begin(), score_metrics().end(),
                         [&](const ScoreMetric& candidate) { return name == candidate.name; });
        return mean_of(*metric, views);
    };
    ViewScore score;
    score.name = "mean";
    score.psnr_db = mean("psnr_db").value_or(0.0);
    score.psnr_covered_db = mean("psnr_covered_db");
    score.ssim = mean("ssim").value_or(0.0);
    score.coverage = mean("coverage").value_or(0.0);
    score.ms = mean("ms").value_or(0.0);
    score.cpu_ms = mean("cpu_ms").value_or(0.0);
    score.flip = mean("flip").value_or(0.0);
    score.flip_covered = mean("flip_covered");
    score.edge_sharpness = mean("edge_sharpness");
    score.psnr_gain_fitted_db = mean("psnr_gain_fitted_db");
    score.ghost_energy = mean("ghost_energy");
    score.psnr_subject_db = mean("psnr_subject_db");
    score.flip_subject = mean("flip_subject");
    score.subject_coverage = mean("subject_coverage");
    return score;
}

std::vector<ViewScore> views_at(ViewPlace place, const std::vector<ViewScore>& views) {
    std::vector<ViewScore> found;
    std::copy_if(views.begin(), views.end(), std::back_inserter(found),
                 [&](const ViewScore& view) { return view.place == place; });
    return found;
}

}  // namespace lumi
