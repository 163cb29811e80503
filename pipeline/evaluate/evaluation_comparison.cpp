#include "pipeline/evaluate/evaluation_comparison.h"

#include <map>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/json_fault.h"
#include "calib/work/mean.h"
#include "pipeline/evaluate/view_score.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// The views of each mode, by name.
using ViewsOfMode = std::map<std::string, std::map<std::string, Json>>;

ViewsOfMode views_by_mode(const Json& evaluation) {
    ViewsOfMode modes;
    const auto add = [&](const std::string& mode, const Json& scores) {
        for (const Json& view : scores.at("views")) {
            modes[mode][view.at("name").get<std::string>()] = view;
        }
    };
    add(evaluation.at("mode").get<std::string>(), evaluation);
    for (const auto& [mode, scores] : evaluation.at("modes").items()) add(mode, scores);
    const Json& rivals = evaluation.at("rivals");
    if (rivals.is_null()) return modes;
    for (const auto& [method, scores] : rivals.at("methods").items()) add(method, scores);
    return modes;
}

MetricComparison compare_metric(const ScoreMetric& metric, const std::vector<std::string>& names,
                                const std::map<std::string, Json>& views_a,
                                const std::map<std::string, Json>& views_b) {
    std::vector<double> a;
    std::vector<double> b;
    std::vector<double> differences;
    for (const std::string& name : names) {
        const Json& value_a = views_a.at(name).at(metric.name);
        const Json& value_b = views_b.at(name).at(metric.name);
        if (value_a.is_null() || value_b.is_null()) continue;
        a.push_back(value_a.get<double>());
        b.push_back(value_b.get<double>());
        differences.push_back(b.back() - a.back());
    }
    MetricComparison comparison{metric.name, {}, {}, {}, {}, {}, {}, metric.higher_is_better};
    if (a.empty()) return comparison;
    comparison.mean_a = mean_of(a);
    comparison.mean_b = mean_of(b);
    comparison.mean_difference = mean_of(differences);
    comparison.range = range_of(differences);
    if (metric.is_time) {
        comparison.ratio = *comparison.mean_b / *comparison.mean_a;
    } else {
        comparison.interval = bootstrap_interval(differences);
    }
    return comparison;
}

/// What an evaluation of an early version does not say is not compared.
bool differ(const Json& view_a, const Json& view_b, const char* key) {
    const Json a = view_a.value(key, Json());
    const Json b = view_b.value(key, Json());
    return !a.is_null() && !b.is_null() && a != b;
}

std::string pixels_text(const Json& view) {
    return view.at("width_px").dump() + " x " + view.at("height_px").dump();
}

void expect_same_photograph(const std::string& name, const Json& view_a, const Json& view_b) {
    const auto refuse = [&](const std::string& reason) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-DISJOINT", name + ": " + reason,
                    "compare evaluations of the same photographs at the same size");
    };
    if (differ(view_a, view_b, "width_px") || differ(view_a, view_b, "height_px"))
        refuse(pixels_text(view_a) + " pixels in A and " + pixels_text(view_b) + " in B");
    if (differ(view_a, view_b, "photograph_sha256"))
        refuse("another photograph in A than in B, of the same name");
}

std::vector<ModeComparison> compare(const Json& a, const Json& b) {
    const ViewsOfMode modes_a = views_by_mode(a);
    const ViewsOfMode modes_b = views_by_mode(b);
    std::vector<ModeComparison> comparisons;
    for (const auto& [mode, views_a] : modes_a) {
        const auto views_b = modes_b.find(mode);
        if (views_b == modes_b.end()) continue;
        ModeComparison comparison{mode, {}, {}};
        for (const auto& [name, view] : views_a) {
            const auto other = views_b->second.find(name);
            if (other == views_b->second.end()) continue;
            expect_same_photograph(name, view, other->second);
            comparison.shared_views.push_back(name);
        }
        if (comparison.shared_views.empty()) continue;
        for (const ScoreMetric& metric : score_metrics()) {
            comparison.metrics.push_back(
                compare_metric(metric, comparison.shared_views, views_a, views_b->second));
        }
        comparisons.push_back(std::move(comparison));
    }
    return comparisons;
}

}  // namespace

std::vector<ModeComparison> compare_evaluations(const Json& a, const Json& b) {
    std::vector<ModeComparison> comparisons;
    try {
        comparisons = compare(a, b);
    } catch (const Json::exception& error) {
        throw Error(ErrorKind::kBadInput, "E-JSON-READ",
                    json_fault("an evaluation lacks what it should say", error),
                    "run `lumi evaluate` again");
    }
    if (comparisons.empty()) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-DISJOINT",
                    "the two evaluations have no view of one mode in common",
                    "compare evaluations that hold out the same photographs");
    }
    return comparisons;
}

std::string judgement_of(const MetricComparison& comparison) {
    if (comparison.ratio) return "not judged";
    const bool is_equal =
        !comparison.range || (comparison.range->low == 0.0 && comparison.range->high == 0.0);
    if (is_equal) return "same";
    if (!comparison.interval) return "too few views";
    const Interval& interval = *comparison.interval;
    if (interval.low <= 0.0 && interval.high >= 0.0) return "same";
    return (interval.low > 0.0) == comparison.higher_is_better ? "better" : "worse";
}

}  // namespace lumi
