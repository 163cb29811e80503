#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "pipeline/commands/commands.h"
#include "pipeline/evaluate/evaluation_comparison.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/optional_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json interval_json(const std::optional<Interval>& interval) {
    return interval ? Json{interval->low, interval->high} : Json();
}

Json comparison_json(const std::vector<ModeComparison>& comparisons) {
    Json modes = Json::object();
    for (const ModeComparison& mode : comparisons) {
        Json metrics = Json::object();
        for (const MetricComparison& metric : mode.metrics) {
            metrics[metric.metric] = {{"a", optional_json(metric.mean_a)},
                                      {"b", optional_json(metric.mean_b)},
                                      {"difference", optional_json(metric.mean_difference)},
                                      {"interval", interval_json(metric.interval)},
                                      {"range", interval_json(metric.range)},
                                      {"ratio", optional_json(metric.ratio)},
                                      {"b_is", judgement_of(metric)}};
        }
        modes[mode.mode] = {{"views", mode.shared_views}, {"metrics", std::move(metrics)}};
    }
    return Json{{"modes", std::move(modes)}};
}

std::string number_or_dash(const std::optional<double>& value) {
    return value ? number_text(*value, 4) : "-";
}

std::string from_to(const Interval& interval) {
    return number_text(interval.low, 4) + " to " + number_text(interval.high, 4);
}

/// How far a difference can be trusted.
std::string spread_text(const MetricComparison& metric) {
    if (metric.ratio) return "   B / A " + number_text(*metric.ratio, 3);
    if (metric.interval) return "   " + from_to(*metric.interval) + "  " + judgement_of(metric);
    return "   range " + from_to(*metric.range) + "  " + judgement_of(metric);
}

std::string comparison_text(const std::vector<ModeComparison>& comparisons) {
    std::string text;
    for (const ModeComparison& mode : comparisons) {
        text += mode.mode + ", " + counted(mode.shared_views.size(), "view") + "\n";
        text += padded_right("", 22) + padded_left("A", 12) + padded_left("B", 12) +
                padded_left("B - A", 12) + "   95 % interval\n";
        for (const MetricComparison& metric : mode.metrics) {
            if (!metric.mean_a) continue;
            text += "  " + padded_right(metric.metric, 20) +
                    padded_left(number_or_dash(metric.mean_a), 12) +
                    padded_left(number_or_dash(metric.mean_b), 12) +
                    padded_left(number_or_dash(metric.mean_difference), 12) + spread_text(metric) +
                    "\n";
        }
    }
    return text;
}

}  // namespace

void add_compare_evaluations_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "compare-evaluations",
        "Two evaluations side by side, over the held-out views that both have: B beside A",
        "lumi compare-evaluations before/evaluation.json work/fountain");
    const auto a = std::make_shared<std::filesystem::path>();
    const auto b = std::make_shared<std::filesystem::path>();
    command.add_option("A", *a, "evaluation.json, or the workspace that holds it")->required();
    command.add_option("B", *b, "The same")->required();
    command.callback([a, b, &context] {
        context.chosen = [a, b, &context] {
            const std::vector<ModeComparison> comparisons =
                compare_evaluations(read_evaluation(*a), read_evaluation(*b));
            if (context.json) {
                context.print_result(comparison_json(comparisons));
            } else {
                context.print_result(comparison_text(comparisons));
            }
        };
    });
}

}  // namespace lumi
