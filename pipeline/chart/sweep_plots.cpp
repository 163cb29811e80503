#include "pipeline/chart/sweep_plots.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "calib/work/median.h"
#include "pipeline/chart/pareto_front.h"

namespace lumi {
namespace {

constexpr const char* kErrorLabel = "FLIP error of held-out photographs (less is better)";

using Cost = std::function<double(const ChartPoint&)>;

/// Seconds from photographs to the first picture.
double first_picture_s(const ChartPoint& point) {
    return point.build_cpu_s + point.frame_ms / 1000.0;
}

std::vector<std::size_t> front_by(const std::vector<ChartPoint>& points, const Cost& cost) {
    std::vector<CostAndError> pairs;
    for (const ChartPoint& point : points) pairs.push_back({cost(point), point.mean.flip});
    return pareto_front(pairs);
}

/// All points by mode, those that are beaten in grey, those on the front labelled.
Plot overview(const std::vector<ChartPoint>& points, const Cost& cost, const std::string& title,
              const std::string& x_label) {
    const std::vector<std::size_t> front = front_by(points, cost);
    const std::set<std::size_t> on_front(front.begin(), front.end());
    Plot plot{.title = title, .x_label = x_label, .y_label = kErrorLabel, .has_log_x = true};
    std::map<RenderMode, PlotSeries> series;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ChartPoint& point = points[i];
        const bool is_best = on_front.contains(i);
        PlotMark mark{.x = cost(point),
                      .y = point.mean.flip,
                      .label = is_best ? point.label : "",
                      .is_faint = !is_best};
        if (is_best) mark.y_range = point.flip_interval;
        series[point.mode].name = name_of(point.mode);
        series[point.mode].marks.push_back(std::move(mark));
    }
    for (auto& [mode, one] : series) plot.series.push_back(std::move(one));
    PlotSeries steps{.name = "Pareto front", .is_stepped = true};
    for (const std::size_t i : front) {
        steps.marks.push_back({.x = cost(points[i]), .y = points[i].mean.flip});
    }
    plot.series.push_back(std::move(steps));
    return plot;
}

/// The stage whose time a setting changes first.
std::string stage_of_setting(const std::string& setting) {
    static const std::map<std::string, std::string> kStages{
        {"capture", "ingest"}, {"calibration", "poses"}, {"poses", "poses"},
        {"mesh", "mesh"},      {"depth", "depth"},       {"package", "pack"}};
    const auto stage = kStages.find(setting.substr(0, setting.find('.')));
    return stage == kStages.end() ? "pack" : stage->second;
}

/// Differs from `reference` in nothing but settings of the stage.
bool varies_only(const Sweep& sweep, const Variant& variant, const Variant& reference,
                 const std::string& stage) {
    for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
        if (stage_of_setting(sweep.axes[i].setting) == stage) continue;
        if (variant.choice[i] != reference.choice[i]) return false;
    }
    return true;
}

std::string label_within(const Sweep& sweep, const Variant& variant, const std::string& stage) {
    std::string label;
    for (std::size_t i = 0; i < sweep.axes.size(); ++i) {
        if (stage_of_setting(sweep.axes[i].setting) != stage) continue;
        label += (label.empty() ? "" : " ") + sweep.axes[i].values[variant.choice[i]];
    }
    return label;
}

/// CPU seconds of the stage; of the whole build where smaller photographs speed up everything.
std::vector<double> times_of(const MeasuredVariant& variant, const std::string& stage) {
    if (stage == "ingest") return {build_cpu_s(variant)};
    for (const StageTimes& times : variant.stages) {
        if (times.stage == stage) return times.cpu_s;
    }
    return {};
}

Plot stage_plot(const ChartResult& result, const std::vector<ChartPoint>& points,
                const ChartPoint& best, const std::string& stage) {
    const std::string what = stage == "ingest" ? "the whole line" : "the stage \"" + stage + "\"";
    Plot plot{.title = stage == "ingest" ? "Image size" : "Stage: " + stage,
              .x_label = "CPU seconds of " + what,
              .y_label = kErrorLabel,
              .has_log_x = true};
    PlotSeries series{.name = name_of(best.mode), .is_joined = true};
    std::vector<CostAndError> pairs;
    for (const ChartPoint& point : points) {
        const Variant& variant = result.sweep.variants[point.variant];
        if (point.mode != best.mode ||
            !varies_only(result.sweep, variant, result.sweep.variants[best.variant], stage)) {
            continue;
        }
        const std::vector<double> times = times_of(result.variants[point.variant], stage);
        if (times.empty()) continue;
        const auto [low, high] = std::minmax_element(times.begin(), times.end());
        series.marks.push_back({.x = median_of(times),
                                .y = point.mean.flip,
                                .x_range = Interval{*low, *high},
                                .y_range = point.flip_interval,
                                .label = label_within(result.sweep, variant, stage)});
        pairs.push_back({series.marks.back().x, series.marks.back().y});
    }
    const std::vector<std::size_t> front = pareto_front(pairs);
    for (std::size_t i = 0; i < series.marks.size(); ++i) {
        series.marks[i].is_faint = std::find(front.begin(), front.end(), i) == front.end();
    }
    std::sort(series.marks.begin(), series.marks.end(),
              [](const PlotMark& a, const PlotMark& b) { return a.x < b.x; });
    plot.series.push_back(std::move(series));
    return plot;
}

}  // namespace

std::vector<std::size_t> front_by_build_time(const std::vector<ChartPoint>& points) {
    return front_by(points, first_picture_s);
}

std::vector<std::size_t> front_by_frame_time(const std::vector<ChartPoint>& points) {
    return front_by(points, [](const ChartPoint& point) { return point.frame_ms; });
}

std::vector<NamedPlot> plots_of(const ChartResult& result) {
    const std::vector<ChartPoint> points = points_of(result);
    const auto best =
        std::min_element(points.begin(), points.end(),
                         [](const auto& a, const auto& b) { return a.mean.flip < b.mean.flip; });
    std::vector<NamedPlot> plots{
        {"end-to-end",
         overview(points, first_picture_s, "End to end: photographs to the first picture",
                  "CPU seconds"),
         "Every point is one way through the line. Grey: another is both faster and better."},
        {"drawing",
         overview(
             points, [](const ChartPoint& p) { return p.frame_ms; }, "Drawing one frame",
             "milliseconds a frame (median)"),
         "The same points by what a frame takes once the package is made."},
        {"size",
         overview(
             points, [](const ChartPoint& p) { return p.package_mib; }, "Size of the package",
             "MiB"),
         "The same points by what has to be handed over."}};
    std::set<std::string> stages;
    for (const SweepAxis& axis : result.sweep.axes) {
        if (axis.values.size() > 1) stages.insert(stage_of_setting(axis.setting));
    }
    for (const char* stage : {"ingest", "poses", "mesh", "depth", "pack"}) {
        if (!stages.contains(stage)) continue;
        plots.push_back({std::string("stage-") + stage, stage_plot(result, points, *best, stage),
                         "All other settings as in the most accurate point: " + best->label + "."});
    }
    return plots;
}

}  // namespace lumi
