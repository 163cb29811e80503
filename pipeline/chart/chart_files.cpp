#include "pipeline/chart/chart_files.h"

#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "pipeline/chart/chart_page.h"
#include "pipeline/chart/sweep_plots.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/text/csv.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json axes_json(const Sweep& sweep) {
    Json axes = Json::object();
    for (const SweepAxis& axis : sweep.axes) axes[axis.setting] = axis.values;
    return axes;
}

Json stages_json(const MeasuredVariant& variant) {
    Json stages = Json::object();
    for (const StageTimes& times : variant.stages) {
        stages[times.stage] = {{"cpu_s", times.cpu_s}, {"wall_s", times.wall_s}};
    }
    return stages;
}

Json variants_json(const ChartResult& result) {
    Json variants = Json::array();
    for (std::size_t i = 0; i < result.variants.size(); ++i) {
        const MeasuredVariant& measured = result.variants[i];
        Json settings = Json::object();
        for (std::size_t axis = 0; axis < result.sweep.axes.size(); ++axis) {
            settings[result.sweep.axes[axis].setting] =
                result.sweep.axes[axis].values[result.sweep.variants[i].choice[axis]];
        }
        Json modes = Json::object();
        for (const ModeScores& scores : measured.scores) {
            modes[name_of(scores.mode)] = mode_scores_json(scores);
        }
        variants.push_back({{"label", result.sweep.variants[i].label},
                            {"settings", std::move(settings)},
                            {"failure", measured.failure},
                            {"stages", stages_json(measured)},
                            {"build_cpu_s", build_cpu_s(measured)},
                            {"build_wall_s", build_wall_s(measured)},
                            {"package_mib", measured.package_mib},
                            {"repeats_are_equal", measured.repeats_are_equal},
                            {"modes", std::move(modes)}});
    }
    return variants;
}

Json labels_json(const std::vector<ChartPoint>& points, const std::vector<std::size_t>& indices) {
    Json labels = Json::array();
    for (const std::size_t index : indices) labels.push_back(points[index].label);
    return labels;
}

std::string number_or_nothing(const std::optional<double>& value) {
    return value ? number_text(*value, 6) : "";
}

}  // namespace

Json chart_json(const ChartResult& result) {
    const std::vector<ChartPoint> points = points_of(result);
    Json modes = Json::array();
    for (const RenderMode mode : result.sweep.modes) modes.push_back(name_of(mode));
    return Json{{"schema_version", 1},
                {"name", result.sweep.name},
                {"settings", axes_json(result.sweep)},
                {"modes", std::move(modes)},
                {"repeats", result.sweep.repeats},
                {"reference_width_px", result.reference_width_px},
                {"held_out", result.shared_views},
                {"gl", result.gl_description},
                {"work",
                 {{"done_cpu_s", result.work.done_cpu_s},
                  {"alone_cpu_s", result.work.alone_cpu_s},
                  {"cached_share", result.work.cached_share()},
                  {"wall_s", result.wall_s}}},
                {"front_by_build_time", labels_json(points, front_by_build_time(points))},
                {"front_by_frame_time", labels_json(points, front_by_frame_time(points))},
                {"variants", variants_json(result)}};
}

std::string chart_csv(const ChartResult& result) {
    std::vector<std::string> heading;
    for (const SweepAxis& axis : result.sweep.axes) heading.push_back(axis.setting);
    for (const char* name : {"mode", "build_cpu_s", "build_wall_s", "package_mib", "frame_ms",
                             "flip", "flip_low", "flip_high", "psnr_db", "psnr_low", "psnr_high",
                             "psnr_covered_db", "ssim", "edge_sharpness", "coverage"}) {
        heading.emplace_back(name);
    }
    std::string csv = csv_row(heading);
    for (const ChartPoint& point : points_of(result)) {
        std::vector<std::string> row;
        const Variant& variant = result.sweep.variants[point.variant];
        for (std::size_t i = 0; i < result.sweep.axes.size(); ++i) {
            row.push_back(result.sweep.axes[i].values[variant.choice[i]]);
        }
        row.push_back(name_of(point.mode));
        for (const double value :
             {point.build_cpu_s, point.build_wall_s, point.package_mib, point.frame_ms}) {
            row.push_back(number_text(value, 3));
        }
        const auto bound = [](const std::optional<Interval>& interval, double Interval::*side) {
            return interval ? number_text((*interval).*side, 6) : std::string();
        };
        row.push_back(number_text(point.mean.flip, 6));
        row.push_back(bound(point.flip_interval, &Interval::low));
        row.push_back(bound(point.flip_interval, &Interval::high));
        row.push_back(number_text(point.mean.psnr_db, 4));
        row.push_back(bound(point.psnr_interval, &Interval::low));
        row.push_back(bound(point.psnr_interval, &Interval::high));
        row.push_back(number_or_nothing(point.mean.psnr_covered_db));
        row.push_back(number_text(point.mean.ssim, 6));
        row.push_back(number_or_nothing(point.mean.edge_sharpness));
        row.push_back(number_text(point.mean.coverage, 6));
        csv += csv_row(row);
    }
    return csv;
}

void write_chart_files(const std::filesystem::path& folder, const ChartResult& result,
                       const Progress& progress) {
    write_json_file(folder / "chart.json", chart_json(result));
    write_whole_text(folder / "chart.csv", chart_csv(result));
    std::vector<DrawnPlot> drawn;
    for (const NamedPlot& plot : plots_of(result)) {
        drawn.push_back({plot_svg(plot.plot, progress), plot.caption});
        write_whole_text(folder / (plot.name + ".svg"), drawn.back().svg);
    }
    write_whole_text(folder / "chart.html", chart_page(result, drawn));
}

}  // namespace lumi
