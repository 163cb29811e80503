#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "pipeline/evaluate/bootstrap.h"

namespace lumi {

/// One figure of two evaluations over the views that both have.
struct MetricComparison {
    std::string metric;
    std::optional<double> mean_a;
    std::optional<double> mean_b;
    std::optional<double> mean_difference;  ///< B - A, view by view.
    /// Bootstrap interval of that mean: when it does not hold 0, the difference is beyond chance.
    /// Empty for few views, and for times: how these differ from view to view says nothing of how
    /// they differ from run to run.
    std::optional<Interval> interval;
    std::optional<Interval> range;  ///< Of the differences.
    std::optional<double> ratio;    ///< Of times: mean B over mean A.
    bool higher_is_better = true;
};

struct ModeComparison {
    std::string mode;
    std::vector<std::string> shared_views;
    std::vector<MetricComparison> metrics;
};

/// Compares two results of `lumi evaluate` mode by mode, over views of equal names. Throws Error
/// (E-EVAL-DISJOINT) when they have no view of any mode in common, or different photographs under
/// one name, and E-JSON-READ.
[[nodiscard]] std::vector<ModeComparison> compare_evaluations(const nlohmann::ordered_json& a,
                                                              const nlohmann::ordered_json& b);

/// "better", "worse" or "same": what B is beside A, as far as the views can tell; "too few views"
/// where they cannot (kFewestForInterval), "not judged" of times.
[[nodiscard]] std::string judgement_of(const MetricComparison& comparison);

}  // namespace lumi
