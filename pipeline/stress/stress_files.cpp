#include "pipeline/stress/stress_files.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/plot.h"
#include "pipeline/report/stress_charts.h"
#include "pipeline/stress/perturbation.h"
#include "pipeline/text/csv.h"
#include "pipeline/text/html.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

/// The names of the perturbations in the order of the curves, each once.
std::vector<std::string> perturbations_of(const StressResult& result) {
    std::vector<std::string> names;
    for (const StressCurve& curve : result.curves) {
        if (names.empty() || names.back() != curve.perturbation) {
            names.push_back(curve.perturbation);
        }
    }
    return names;
}

Plot plot_of(const StressResult& result, const std::string& perturbation) {
    Plot plot;
    plot.title = "What " + words_of_perturbation(perturbation) + " costs";
    plot.x_label = words_of_perturbation(perturbation);
    plot.y_label = "dB lost on photographs not used";
    for (const StressCurve& curve : result.curves) {
        if (curve.perturbation != perturbation) continue;
        PlotSeries series{.name = name_of(curve.mode), .is_joined = true};
        for (std::size_t i = 0; i < curve.strengths.size(); ++i) {
            series.marks.push_back(
                {.x = curve.strengths[i], .y = curve.psnr_db.front() - curve.psnr_db[i]});
        }
        if (curve.breaking_point) {
            plot.vertical_lines.push_back({*curve.breaking_point, plot.series.size()});
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

std::string breaking_point_text(const StressCurve& curve) {
    if (curve.breaking_point) return number_text(*curve.breaking_point, 3);
    return "beyond " + number_text(curve.strengths.back(), 1);
}

std::string csv_of(const StressResult& result) {
    std::string csv = csv_row({"perturbation", "mode", "strength", "psnr_db", "lost_db"});
    for (const StressCurve& curve : result.curves) {
        for (std::size_t i = 0; i < curve.strengths.size(); ++i) {
            csv += csv_row({curve.perturbation, name_of(curve.mode),
                            number_text(curve.strengths[i], 4), number_text(curve.psnr_db[i], 6),
                            number_text(curve.psnr_db.front() - curve.psnr_db[i], 6)});
        }
    }
    return csv;
}

std::string page_of(const StressResult& result, const std::vector<std::string>& drawings) {
    std::vector<std::vector<std::string>> rows;
    for (const StressCurve& curve : result.curves) {
        rows.push_back({words_of_perturbation(curve.perturbation), name_of(curve.mode),
                        number_text(curve.psnr_db.front(), 2), breaking_point_text(curve)});
    }
    std::string body =
        "<p>" +
        html_escaped(
            "Each curve starts at the package as it is. Dashed lines are where a "
            "mode has lost " +
            number_text(result.max_loss_db, 1) + " dB. Compared with " +
            (result.views_are_held_out ? counted(result.views.size(), "held-out photograph") + "."
                                       : counted(result.views.size(), "photograph") +
                                             " left out of the drawing; the depth of the "
                                             "others was found with them.")) +
        "</p>\n";
    const std::vector<std::string> names = perturbations_of(result);
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        body += html_svg_figure(drawings[i], words_of_perturbation(names[i]));
    }
    body += html_section(
        "Breaking points",
        html_table({"what is wrong", "mode", "unperturbed (dB)",
                    "strength that costs " + number_text(result.max_loss_db, 1) + " dB"},
                   rows));
    return html_page("Driven to the breaking point: " + result.name, body);
}

}  // namespace

Json stress_json(const StressResult& result) {
    Json curves = Json::array();
    for (const StressCurve& curve : result.curves) {
        curves.push_back(
            {{"perturbation", curve.perturbation},
             {"mode", name_of(curve.mode)},
             {"strengths", curve.strengths},
             {"psnr_db", curve.psnr_db},
             {"breaking_point", curve.breaking_point ? Json(*curve.breaking_point) : Json()}});
    }
    return Json{{"schema_version", 1},
                {"name", result.name},
                {"package_sha256", result.package_sha256},
                {"seed", result.seed},
                {"max_loss_db", result.max_loss_db},
                {"views", result.views},
                {"views_are_held_out", result.views_are_held_out},
                {"curves", std::move(curves)}};
}

void write_stress_files(const std::filesystem::path& folder, const StressResult& result,
                        const Progress& progress) {
    // It vouches for the charts: until all are written, none does.
    std::filesystem::remove(folder / kStressFiguresName);
    write_whole_text(folder / "stress.csv", csv_of(result));
    std::vector<std::string> drawings;
    for (const std::string& name : perturbations_of(result)) {
        drawings.push_back(plot_svg(plot_of(result, name), progress));
        write_whole_text(stress_chart_path(folder, name), drawings.back());
    }
    write_whole_text(folder / "stress.html", page_of(result, drawings));
    write_json_file(folder / kStressFiguresName, stress_json(result));
}

}  // namespace lumi
