#include "pipeline/chart/view_curve_plots.h"

#include <algorithm>
#include <limits>

#include "calib/work/whole_file.h"
#include "pipeline/chart/plot.h"

namespace lumi {
namespace {

constexpr const char* kViews = "views kept";

Plot loss_plot(const ViewCurve& curve) {
    double best_db = -std::numeric_limits<double>::infinity();
    for (const ViewCurvePoint& point : curve.points) best_db = std::max(best_db, point.psnr_db);
    PlotSeries chosen{"those missed most", {}, true, false};
    PlotSeries random{"chosen at random: mean, standard deviation", {}, true, false};
    for (const ViewCurvePoint& point : curve.points) {
        const double views = point.views;
        chosen.marks.push_back({views, best_db - point.psnr_db, {}, {}, {}, false});
        if (!(point.random_psnr_db > 0)) continue;
        const double loss = best_db - point.random_psnr_db;
        random.marks.push_back(
            {views,
             loss,
             {},
             Interval{loss - point.random_deviation_db, loss + point.random_deviation_db},
             {},
             false});
    }
    Plot plot{"What fewer views cost", kViews, "PSNR lost, dB", true, false, {chosen}, {}};
    if (!random.marks.empty()) plot.series.push_back(random);
    plot.vertical_lines.push_back({static_cast<double>(curve.third_db_views), 0});
    return plot;
}

Plot cost_plot(const ViewCurve& curve, const char* title, const char* label,
               double ViewCurvePoint::*cost) {
    PlotSeries series{{}, {}, true, false};
    for (const ViewCurvePoint& point : curve.points) {
        series.marks.push_back({static_cast<double>(point.views), point.*cost, {}, {}, {}, false});
    }
    return {title, kViews, label, true, false, {series}, {}};
}

}  // namespace

void draw_view_curve(const std::filesystem::path& folder, const ViewCurve& curve,
                     const Progress& progress) {
    write_whole_text(folder / "loss.svg", plot_svg(loss_plot(curve), progress));
    write_whole_text(folder / "mib.svg",
                     plot_svg(cost_plot(curve, "What views take in a GL's memory", "MiB",
                                        &ViewCurvePoint::texture_mib),
                              progress));
    write_whole_text(folder / "ms.svg", plot_svg(cost_plot(curve, "What views cost in time",
                                                           "ms a frame", &ViewCurvePoint::ms),
                                                 progress));
}

}  // namespace lumi
