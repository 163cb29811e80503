#include "pipeline/depth_bench/stability_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "calib/work/whole_file.h"
#include "pipeline/chart/plot.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

std::string strength_text(double strength) {
    std::ostringstream text;
    text << strength;
    return text.str();
}

std::vector<std::string> models_of(const std::vector<StabilityTrial>& trials) {
    std::vector<std::string> models;
    for (const RungStability& rung : trials.front().rungs) models.push_back(rung.model);
    return models;
}

std::vector<DepthHazard> hazards_of(const std::vector<StabilityTrial>& trials) {
    std::vector<DepthHazard> hazards;
    for (const StabilityTrial& trial : trials) {
        if (std::find(hazards.begin(), hazards.end(), trial.hazard) == hazards.end()) {
            hazards.push_back(trial.hazard);
        }
    }
    return hazards;
}

Json breaking_json(const std::vector<StabilityTrial>& trials) {
    Json json = Json::object();
    for (const DepthHazard hazard : hazards_of(trials)) {
        Json points = Json::object();
        for (const std::string& model : models_of(trials)) {
            const auto strength = breaking_strength(trials, hazard, model);
            points[model] = strength ? Json(*strength) : Json();
        }
        json[curve_of(hazard).name] = std::move(points);
    }
    return json;
}

std::string stability_csv(const std::vector<StabilityTrial>& trials) {
    std::string csv =
        "hazard,strength,seed,model,right_share,claimed_share,claimed_right_share,is_warned,"
        "claims_too_much,cpu_s\n";
    for (const StabilityTrial& trial : trials) {
        for (const RungStability& rung : trial.rungs) {
            csv += curve_of(trial.hazard).name + "," + strength_text(trial.strength) + "," +
                   std::to_string(trial.seed) + "," + rung.model + "," +
                   number_text(rung.right_share, 4) + "," + number_text(rung.claimed_share, 4) +
                   "," + number_text(rung.claimed_right_share, 4) + "," +
                   (rung.is_warned ? "1," : "0,") + (claims_too_much(rung) ? "1," : "0,") +
                   number_text(rung.cpu_s, 3) + "\n";
        }
    }
    return csv;
}

Plot plot_of(const std::vector<StabilityTrial>& trials, DepthHazard hazard) {
    const DepthHazardCurve& curve = curve_of(hazard);
    Plot plot;
    plot.title = curve.title;
    plot.x_label = curve.strength;
    plot.y_label = "visible textured pixels right to 1 px, percent";
    plot.has_log_x = true;
    plot.x_ticks = curve.strengths;  // Harmless on the left, whether that is much or little.
    for (const std::string& model : models_of(trials)) {
        PlotSeries series{.name = model, .is_joined = true};
        for (const double strength : curve.strengths) {
            const auto share = mean_right_share(trials, hazard, strength, model);
            if (share) series.marks.push_back({.x = strength, .y = 100 * *share});
        }
        if (const auto strength = breaking_strength(trials, hazard, model)) {
            plot.vertical_lines.push_back({*strength, plot.series.size()});
        }
        plot.series.push_back(std::move(series));
    }
    return plot;
}

std::string header(const std::vector<StabilityTrial>& trials) {
    std::string text = column("hazard", 14) + column("strength", 10) + column("seed", 6);
    for (const std::string& model : models_of(trials)) text += column(model, 15);
    return text + "\n";
}

}  // namespace

Json stability_json(const std::vector<StabilityTrial>& trials) {
    Json rows = Json::array();
    for (const StabilityTrial& trial : trials) {
        Json rungs = Json::array();
        for (const RungStability& rung : trial.rungs) {
            rungs.push_back({{"model", rung.model},
                             {"right_share", rung.right_share},
                             {"claimed_share", rung.claimed_share},
                             {"claimed_right_share", rung.claimed_right_share},
                             {"is_warned", rung.is_warned},
                             {"claims_too_much", claims_too_much(rung)},
                             {"cpu_s", rung.cpu_s}});
        }
        rows.push_back({{"hazard", curve_of(trial.hazard).name},
                        {"strength", trial.strength},
                        {"seed", trial.seed},
                        {"rungs", std::move(rungs)}});
    }
    return Json{{"breaking_strengths", breaking_json(trials)}, {"rows", std::move(rows)}};
}

std::string stability_row(const StabilityTrial& trial) {
    std::string text = column(curve_of(trial.hazard).name, 14) +
                       column(strength_text(trial.strength), 10) +
                       column(std::to_string(trial.seed), 6);
    for (const RungStability& rung : trial.rungs) {
        const std::string mark = rung.is_warned ? " w" : claims_too_much(rung) ? " !" : "";
        text += column(number_text(100 * rung.right_share, 1) + mark, 15);
    }
    return text;
}

std::string stability_text(const std::vector<StabilityTrial>& trials) {
    std::string text = header(trials);
    for (const StabilityTrial& trial : trials) text += stability_row(trial) + "\n";
    text +=
        "\nPercent of the visible textured pixels within 1 px of the true disparity. !: claims "
        "a tenth of the picture\nor more and is wrong in more than a fifth of it.\n\nbreaks at\n";
    for (const DepthHazard hazard : hazards_of(trials)) {
        text += column(curve_of(hazard).name, 30);
        for (const std::string& model : models_of(trials)) {
            const auto strength = breaking_strength(trials, hazard, model);
            text += column(strength ? strength_text(*strength) : "-", 15);
        }
        text += "\n";
    }
    return text;
}

void write_stability_report(const std::filesystem::path& folder,
                            const std::vector<StabilityTrial>& trials, const Progress& progress) {
    const DepthHazard last = trials.back().hazard;
    write_json_file(folder / "stability.json", stability_json(trials));
    write_whole_text(folder / "stability.csv", stability_csv(trials));
    write_whole_text(folder / ("stability-" + curve_of(last).name + ".svg"),
                     plot_svg(plot_of(trials, last), progress));
}

}  // namespace lumi
