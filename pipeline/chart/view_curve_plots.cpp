#include "pipeline/chart/view_curve_plots.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "calib/work/whole_file.h"
#include "pipeline/chart/plot.h"

namespace lumi {
namespace {

constexpr const char* kViews = "views kept";

/// The numbers of views, but for those that stand too close to the one before to be read.
std::vector<double> ticks_of(const ViewCurve& curve) {
    constexpr double kLeastRatio = 1.15;
    std::set<double> views;
    for (const ViewCurvePoint& point : curve.points) views.insert(point.views);
    if (views.size() < 2) return {};
    std::vector<double> ticks{*views.begin()};
    for (const double tick : views) {
        if (tick >= kLeastRatio * ticks.back()) ticks.push_back(tick);
    }
    // The axis ends at the last of them.
    if (ticks.size() > 1 && *views.rbegin() < kLeastRatio * ticks.back()) ticks.pop_back();
    if (*views.rbegin() > ticks.back()) ticks.push_back(*views.rbegin());
    return ticks;
}

Plot loss_plot(const ViewCurve& curve) {
    double best_db = -std::numeric_limits<double>::infinity();
    for (const ViewCurvePoint& point : curve.points) best_db = std::max(best_db, point.psnr_db);
    PlotSeries chosen{.name = "those missed most", .is_joined = true};
    PlotSeries random{.name = "chosen at random: mean, standard deviation", .is_joined = true};
    for (const ViewCurvePoint& point : curve.points) {
        const double views = point.views;
        chosen.marks.push_back({.x = views, .y = best_db - point.psnr_db});
        if (!(point.random_psnr_db > 0)) continue;
        const double loss = best_db - point.random_psnr_db;
        random.marks.push_back({.x = views,
                                .y = loss,
                                .y_range = Interval{loss - point.random_deviation_db,
                                                    loss + point.random_deviation_db}});
    }
    Plot plot{.title = "What fewer views cost",
              .x_label = kViews,
              .y_label = "PSNR lost, dB",
              .has_log_x = true,
              .series = {chosen},
              .x_ticks = ticks_of(curve)};
    if (!random.marks.empty()) plot.series.push_back(random);
    plot.vertical_lines.push_back({static_cast<double>(curve.third_db_views), 0});
    return plot;
}

Plot cost_plot(const ViewCurve& curve, const char* title, const char* label,
               double ViewCurvePoint::*cost) {
    PlotSeries series{.is_joined = true};
    for (const ViewCurvePoint& point : curve.points) {
        series.marks.push_back({.x = static_cast<double>(point.views), .y = point.*cost});
    }
    return {.title = title,
            .x_label = kViews,
            .y_label = label,
            .has_log_x = true,
            .series = {series},
            .x_ticks = ticks_of(curve)};
}

}  // namespace

std::vector<std::filesystem::path> draw_view_curve(const std::filesystem::path& folder,
                                                   const ViewCurve& curve,
                                                   const Progress& progress) {
    const std::vector<std::pair<std::filesystem::path, Plot>> plots{
        {folder / "loss.svg", loss_plot(curve)},
        {folder / "mib.svg",
         cost_plot(curve, "What views take in a GL's memory", "MiB", &ViewCurvePoint::texture_mib)},
        {folder / "ms.svg",
         cost_plot(curve, "What views cost in time", "ms a frame", &ViewCurvePoint::ms)}};
    std::vector<std::filesystem::path> written;
    for (const auto& [path, plot] : plots) {
        write_whole_text(path, plot_svg(plot, progress));
        written.push_back(path);
    }
    return written;
}

}  // namespace lumi
