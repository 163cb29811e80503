#include "pipeline/chart/growth_files.h"

#include <functional>
#include <nlohmann/json.hpp>

#include "calib/work/whole_file.h"
#include "pipeline/chart/power_law.h"
#include "pipeline/line/line.h"
#include "pipeline/report/report_sources.h"
#include "pipeline/text/csv.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using Figure = std::function<double(const GrowthSample&)>;

/// What grows, and what it grows with.
struct GrowthAxis {
    const char* name;
    const char* title;
    const char* label;
    Figure figure;
};

const std::vector<GrowthAxis>& what_grows() {
    static const std::vector<GrowthAxis> axes{
        {"cpu", "Time", "CPU seconds", [](const GrowthSample& s) { return s.cpu_s; }},
        {"memory", "Memory", "peak MiB of the stage",
         [](const GrowthSample& s) { return s.peak_mib; }}};
    return axes;
}

const GrowthAxis kByPhotographs{"photographs", "number of photographs", "photographs",
                                [](const GrowthSample& s) { return double(s.photographs); }};
const GrowthAxis kBySize{"size", "size of photographs", "megapixels of a photograph",
                         [](const GrowthSample& s) { return s.megapixels; }};

/// One stage's figures against what they grow with.
struct Growth {
    std::vector<double> x;
    std::vector<double> y;
};

Growth growth_of(const std::vector<GrowthSample>& samples, const std::string& stage,
                 const Figure& x, const Figure& y) {
    Growth growth;
    for (const GrowthSample& sample : samples) {
        if (sample.stage != stage) continue;
        growth.x.push_back(x(sample));
        growth.y.push_back(y(sample));
    }
    return growth;
}

void append_plot(std::vector<NamedPlot>& plots, const std::vector<GrowthSample>& samples,
                 const GrowthAxis& x, const GrowthAxis& y) {
    Plot plot{.title = std::string(y.title) + " against " + x.title,
              .x_label = x.label,
              .y_label = y.label,
              .has_log_x = true,
              .has_log_y = true};
    bool has_fit = false;
    for (const std::string& stage : stages_of_line()) {
        const Growth growth = growth_of(samples, stage, x.figure, y.figure);
        PlotSeries series{.name = stage, .is_joined = true};
        if (const auto law = fit_power_law(growth.x, growth.y)) {
            series.name += " ~ n^" + number_text(law->exponent, 2);
            has_fit = true;
        }
        for (std::size_t i = 0; i < growth.x.size(); ++i) {
            series.marks.push_back({.x = growth.x[i], .y = growth.y[i]});
        }
        plot.series.push_back(std::move(series));
    }
    if (!has_fit) return;
    plots.push_back({std::string("growth-") + y.name + "-" + x.name, std::move(plot),
                     "Both axes are logarithmic: a straight line is a power, and its exponent "
                     "stands in the key."});
}

Json samples_json(const std::vector<GrowthSample>& samples) {
    Json list = Json::array();
    for (const GrowthSample& sample : samples) {
        list.push_back({{"stage", sample.stage},
                        {"photographs", sample.photographs},
                        {"megapixels", sample.megapixels},
                        {"cpu_s", sample.cpu_s},
                        {"wall_s", sample.wall_s},
                        {"peak_mib", sample.peak_mib}});
    }
    return list;
}

Json exponents_json(const std::vector<GrowthSample>& samples, const GrowthAxis& x) {
    Json stages = Json::object();
    for (const std::string& stage : stages_of_line()) {
        for (const GrowthAxis& y : what_grows()) {
            const Growth growth = growth_of(samples, stage, x.figure, y.figure);
            if (const auto law = fit_power_law(growth.x, growth.y)) {
                stages[stage][y.name] = {{"exponent", law->exponent},
                                         {"standard_error", law->exponent_error}};
            }
        }
    }
    return stages;
}

TableRows rows_of(const GrowthResult& growth) {
    TableRows rows;
    for (const auto* samples : {&growth.by_photographs, &growth.by_size}) {
        for (const GrowthSample& sample : *samples) {
            rows.push_back({sample.stage, std::to_string(sample.photographs),
                            number_text(sample.megapixels, 3), number_text(sample.cpu_s, 2),
                            number_text(sample.wall_s, 2), number_text(sample.peak_mib, 0)});
        }
    }
    return rows;
}

}  // namespace

std::vector<NamedPlot> growth_plots(const GrowthResult& growth) {
    std::vector<NamedPlot> plots;
    for (const GrowthAxis& y : what_grows()) {
        append_plot(plots, growth.by_photographs, kByPhotographs, y);
        append_plot(plots, growth.by_size, kBySize, y);
    }
    return plots;
}

Json growth_json(const GrowthResult& growth) {
    return Json{{"schema_version", 1},
                {"by_photographs",
                 {{"samples", samples_json(growth.by_photographs)},
                  {"exponents", exponents_json(growth.by_photographs, kByPhotographs)}}},
                {"by_size",
                 {{"samples", samples_json(growth.by_size)},
                  {"exponents", exponents_json(growth.by_size, kBySize)}}},
                {"failures", growth.failures}};
}

void write_growth_files(const std::filesystem::path& folder, const std::string& name,
                        const GrowthResult& growth, const Progress& progress) {
    const std::vector<std::string> headings{"stage",       "photographs", "megapixels",
                                            "CPU seconds", "seconds",     "peak MiB"};
    write_json_file(folder / "growth.json", growth_json(growth));
    std::string csv = csv_row(headings);
    for (const auto& row : rows_of(growth)) csv += csv_row(row);
    write_whole_text(folder / "growth.csv", csv);
    std::string body =
        "<p>Every stage ran in a process of its own, so that its memory is its own.</p>\n";
    for (const NamedPlot& plot : growth_plots(growth)) {
        const std::string svg = plot_svg(plot.plot, progress);
        write_whole_text(folder / (plot.name + ".svg"), svg);
        body += html_svg_figure(svg, plot.caption);
    }
    for (const std::string& failure : growth.failures) {
        body += "<p>" + html_escaped(failure) + "</p>\n";
    }
    body += html_section("Figures", html_table(headings, rows_of(growth)));
    write_whole_text(folder / "growth.html", html_page("How it grows: " + name, body));
}

}  // namespace lumi
