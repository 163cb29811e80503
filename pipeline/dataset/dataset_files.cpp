#include "pipeline/dataset/dataset_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/printable.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/plot.h"
#include "pipeline/text/csv.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

std::vector<std::string> row_of(const SceneOutcome& outcome) {
    std::vector<std::string> row{outcome.name};
    if (outcome.failure) {
        row.push_back(printable(failure_text(*outcome.failure)));
        row.resize(9);
        return row;
    }
    row.insert(row.end(), {"built",
                           std::to_string(outcome.photographs.placed) + " of " +
                               std::to_string(outcome.photographs.total),
                           number_text(outcome.cpu_s, 1), number_text(outcome.package_mib, 1)});
    if (outcome.mean) {
        row.insert(
            row.end(),
            {number_text(outcome.mean->psnr_db, 2), number_text(outcome.mean->ssim, 4),
             number_text(outcome.mean->flip, 4), number_text(100.0 * outcome.mean->coverage, 1)});
    }
    row.resize(9);
    return row;
}

const std::vector<std::string>& headings() {
    static const std::vector<std::string> texts{"scene", "state",         "placed",
                                                "CPU s", "package (MiB)", "PSNR (dB)",
                                                "SSIM",  "FLIP",          "covered (%)"};
    return texts;
}

Plot plot_of(const std::string& name, const std::vector<SceneOutcome>& outcomes) {
    Plot plot{.title = "Scenes of " + name,
              .x_label = "CPU seconds from photographs to package",
              .y_label = "FLIP error of held-out photographs (less is better)",
              .has_log_x = true};
    PlotSeries series;
    for (const SceneOutcome& outcome : outcomes) {
        if (!outcome.mean) continue;
        series.marks.push_back({.x = outcome.cpu_s,
                                .y = outcome.mean->flip,
                                .y_range = outcome.flip_interval,
                                .label = outcome.name});
    }
    plot.series.push_back(std::move(series));
    return plot;
}

std::string page_of(const std::string& name, const std::vector<SceneOutcome>& outcomes,
                    const std::string& svg) {
    const auto failed = std::count_if(outcomes.begin(), outcomes.end(),
                                      [](const auto& o) { return o.failure.has_value(); });
    Rows rows;
    for (const SceneOutcome& outcome : outcomes) rows.push_back(row_of(outcome));
    std::string body = "<div class=\"verdict " + std::string(failed == 0 ? "good" : "fair") +
                       "\"><strong>" +
                       std::to_string(outcomes.size() - static_cast<std::size_t>(failed)) + " of " +
                       std::to_string(outcomes.size()) + " scenes were built.</strong></div>\n";
    if (!svg.empty()) body += html_svg_figure(svg, "Seconds against error, one mark a scene");
    return html_page("Dataset: " + name, body + html_table(headings(), rows));
}

}  // namespace

Json dataset_json(const std::string& name, const std::vector<SceneOutcome>& outcomes) {
    Json scenes = Json::array();
    for (const SceneOutcome& outcome : outcomes) {
        Json scene{{"name", outcome.name},
                   {"failure_code", outcome.failure ? outcome.failure->code() : ""},
                   {"failure", outcome.failure ? printable(outcome.failure->what()) : ""},
                   {"failure_advice", outcome.failure ? printable(outcome.failure->advice()) : ""},
                   {"photographs", outcome.photographs.total},
                   {"placed", outcome.photographs.placed},
                   {"cpu_s", outcome.cpu_s},
                   {"wall_s", outcome.wall_s},
                   {"package_mib", outcome.package_mib},
                   {"mean", Json()}};
        if (outcome.mean) {
            Json mean = Json::object();
            for (const ScoreMetric& metric : score_metrics()) {
                const auto value = metric.value(*outcome.mean);
                mean[metric.name] = value ? Json(*value) : Json();
            }
            scene["mean"] = std::move(mean);
        }
        scenes.push_back(std::move(scene));
    }
    return Json{{"schema_version", 1}, {"name", name}, {"scenes", std::move(scenes)}};
}

void write_dataset_files(const std::filesystem::path& folder, const std::string& name,
                         const std::vector<SceneOutcome>& outcomes, const Progress& progress) {
    write_json_file(folder / "dataset.json", dataset_json(name, outcomes));
    std::string csv = csv_row(headings());
    for (const SceneOutcome& outcome : outcomes) csv += csv_row(row_of(outcome));
    write_whole_text(folder / "dataset.csv", csv);
    std::string svg;
    if (std::any_of(outcomes.begin(), outcomes.end(), [](const auto& o) { return o.mean; })) {
        svg = plot_svg(plot_of(name, outcomes), progress);
        write_whole_text(folder / "dataset.svg", svg);
    }
    write_whole_text(folder / "dataset.html", page_of(name, outcomes, svg));
}

}  // namespace lumi
