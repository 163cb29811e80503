#include "pipeline/chart/chart_page.h"

#include <algorithm>

#include "calib/work/counted.h"
#include "calib/work/median.h"
#include "pipeline/chart/sweep_plots.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"

namespace lumi {
namespace {

using Rows = std::vector<std::vector<std::string>>;

std::vector<std::string> row_of(const ChartPoint& point) {
    return {point.label,
            number_text(point.build_cpu_s, 1),
            number_text(point.frame_ms, 1),
            number_text(point.package_mib, 1),
            number_text(point.mean.flip, 4),
            number_text(point.mean.psnr_db, 2),
            number_text(point.mean.ssim, 4),
            number_text(100.0 * point.mean.coverage, 1)};
}

const std::vector<std::string>& headings() {
    static const std::vector<std::string> texts{"settings",      "build (CPU s)", "frame (ms)",
                                                "package (MiB)", "FLIP",          "PSNR (dB)",
                                                "SSIM",          "covered (%)"};
    return texts;
}

std::string table_of(const std::vector<ChartPoint>& points,
                     const std::vector<std::size_t>& indices) {
    Rows rows;
    for (const std::size_t index : indices) rows.push_back(row_of(points[index]));
    return html_table(headings(), rows);
}

/// What the first and the last point of the front cost and give.
std::string summary(const std::vector<ChartPoint>& points) {
    const std::vector<std::size_t> front = front_by_build_time(points);
    const ChartPoint& quick = points[front.front()];
    const ChartPoint& good = points[front.back()];
    const auto told = [](const ChartPoint& point) {
        return point.label + ": " + number_text(point.build_cpu_s, 1) + " CPU s, " +
               number_text(point.frame_ms, 1) + " ms a frame, FLIP " +
               number_text(point.mean.flip, 3) + ", " + number_text(point.mean.psnr_db, 1) + " dB";
    };
    return "<div class=\"verdict good\"><strong>Quickest that nothing beats</strong><br>" +
           html_escaped(told(quick)) + "<br><strong>Most accurate</strong><br>" +
           html_escaped(told(good)) + "</div>\n";
}

std::string failures(const ChartResult& result) {
    Rows rows;
    for (std::size_t i = 0; i < result.variants.size(); ++i) {
        if (result.variants[i].failure.empty()) continue;
        rows.push_back({result.sweep.variants[i].label, result.variants[i].failure});
    }
    if (rows.empty()) return {};
    return html_section("Could not be built", html_table({"settings", "why"}, rows));
}

std::string stage_times(const ChartResult& result) {
    Rows rows;
    for (std::size_t i = 0; i < result.variants.size(); ++i) {
        for (const StageTimes& times : result.variants[i].stages) {
            const auto [low, high] = std::minmax_element(times.cpu_s.begin(), times.cpu_s.end());
            rows.push_back({result.sweep.variants[i].label, times.stage,
                            number_text(median_of(times.cpu_s), 2), number_text(*low, 2),
                            number_text(*high, 2), number_text(median_of(times.wall_s), 2)});
        }
    }
    return html_details("Seconds of every stage", html_table({"settings", "stage", "CPU s (median)",
                                                              "least", "most", "seconds (median)"},
                                                             rows));
}

/// Whether repetitions gave the same packages, where there were any.
std::string on_repetitions(const ChartResult& result) {
    if (result.sweep.repeats < 2) return {};
    const auto unequal = std::count_if(result.variants.begin(), result.variants.end(),
                                       [](const auto& v) { return !v.repeats_are_equal; });
    if (unequal == 0) {
        return " Every stage ran " + std::to_string(result.sweep.repeats) +
               " times; the packages were equal to the last bit.";
    }
    return " Every stage ran " + std::to_string(result.sweep.repeats) + " times; " +
           std::to_string(unequal) + " packages were not equal each time.";
}

std::string conditions(const ChartResult& result) {
    return "<p>" +
           html_escaped("All are compared with the same " +
                        counted(result.shared_views.size(), "held-out photograph") + " at " +
                        std::to_string(result.reference_width_px) +
                        " pixels, whatever size they were made from; bars, where "
                        "six and more were compared, are 95 % bootstrap intervals over views. " +
                        number_text(100.0 * result.work.cached_share(), 0) +
                        " % of the work came from the cache (" +
                        number_text(result.work.done_cpu_s, 0) + " instead of " +
                        number_text(result.work.alone_cpu_s, 0) + " CPU s)." +
                        on_repetitions(result) + " Drawn with " + result.gl_description + ".") +
           "</p>\n";
}

}  // namespace

std::string chart_page(const ChartResult& result, const std::vector<DrawnPlot>& plots) {
    const std::vector<ChartPoint> points = points_of(result);
    std::vector<std::size_t> all(points.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    std::string body = summary(points);
    for (const DrawnPlot& plot : plots) body += html_svg_figure(plot.svg, plot.caption);
    body += html_section("The front, by build time", table_of(points, front_by_build_time(points)));
    body += failures(result);
    body += html_section("How it was measured",
                         conditions(result) + html_details("Every point", table_of(points, all)) +
                             stage_times(result));
    return html_page("Speed against accuracy: " + result.sweep.name, body);
}

}  // namespace lumi
