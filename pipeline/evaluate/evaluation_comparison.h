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
    std::optional<Interval> interval;
    bool higher_is_better = true;
};

struct ModeComparison {
    std::string mode;
    std::vector<std::string> shared_views;
    std::vector<MetricComparison> metrics;
};

/// Compares two results of `lumi evaluate` mode by mode, over views of equal names. Throws Error
/// (E-EVAL-DISJOINT) when they have no view of any mode in common, and E-JSON-READ.
[[nodiscard]] std::vector<ModeComparison> compare_evaluations(const nlohmann::ordered_json& a,
                                                              const nlohmann::ordered_json& b);

/// "better", "worse" or "same": what B is beside A, as far as the views can tell.
[[nodiscard]] std::string judgement_of(const MetricComparison& comparison);

}  // namespace lumi
