#include "pipeline/regression/version_figures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "pipeline/evaluate/evaluation.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/workspace/json_file.h"
#include "render/bench/frame_timing.h"
#include "render/lumigraph/package.h"
#include "render/paths/path_through_views.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;
constexpr int kWidthPx = 1280;
constexpr int kHeightPx = 720;
constexpr double kTimeNoise = 0.05;

/// How much a figure may differ between two OpenGLs that are both right.
double noise_of(const std::string& metric) {
    return metric.ends_with("_db") ? 0.02 : metric == "edge_sharpness" ? 0.005 : 0.0005;
}

void append_errors(VersionFigures& figures, const Evaluation& evaluation) {
    for (const ModeScores& scores : evaluation.modes) {
        for (const ScoreMetric& metric : score_metrics()) {
            const std::string name = metric.name;
            const auto mean = mean_of(metric, scores.views);
            if (!mean || name == "ms" || name == "ghost_energy") continue;
            figures["error." + name_of(scores.mode) + "." + name] = {*mean, noise_of(name),
                                                                     metric.higher_is_better};
        }
    }
}

void append_ratios(VersionFigures& figures, const Lumigraph& lumigraph,
                   const std::vector<RenderMode>& modes, int frames, int rounds,
                   Progress& progress) {
    std::vector<RenderOptions> options;
    for (const RenderMode mode : modes) options.push_back({.mode = mode});
    std::map<RenderMode, std::vector<double>> ratios;
    for (int round = 0; round < rounds; ++round) {
        const FrameTimingReport report =
            time_frames(lumigraph, path_through_views(lumigraph, frames, kWidthPx, kHeightPx),
                        options, progress);
        for (const ModeCost& cost : report.modes) ratios[cost.options.mode].push_back(cost.ratio);
    }
    for (auto& [mode, values] : ratios) {
        std::sort(values.begin(), values.end());
        const double median = values[values.size() / 2];
        figures["ratio." + name_of(mode)] = {
            median, (values.back() - values.front()) / 2.0 + kTimeNoise * median, false};
    }
}

}  // namespace

VersionFigures measure_version(const WorkspaceLayout& workspace, int frames, int rounds,
                               int threads, Progress& progress) {
    const PosedPhotographs held_out = held_out_photographs(workspace, threads);
    const Lumigraph lumigraph = read_package(workspace.package_folder());
    const std::vector<RenderMode> modes = all_render_modes();
    VersionFigures figures;
    append_errors(figures, evaluate_held_out(
                               lumigraph, held_out,
                               {.modes = modes, .ghost_energy = false, .timed_frames = 1},
                               [](RenderMode, const JudgedView&) {}, progress));
    append_ratios(figures, lumigraph, modes, frames, rounds, progress);
    return figures;
}

Json version_figures_json(const VersionFigures& figures) {
    Json list = Json::object();
    for (const auto& [name, figure] : figures) {
        list[name] = {{"value", figure.value},
                      {"noise", figure.noise},
                      {"higher_is_better", figure.higher_is_better}};
    }
    return Json{{"schema_version", kSchemaVersion}, {"figures", std::move(list)}};
}

VersionFigures read_version_figures(const std::filesystem::path& path) {
    const Json json = read_json_file(path);
    VersionFigures figures;
    try {
        if (json.at("schema_version") != kSchemaVersion) refuse_json(path, "another version");
        for (const auto& [name, figure] : json.at("figures").items()) {
            figures[name] = {figure.at("value"), figure.at("noise"), figure.at("higher_is_better")};
        }
    } catch (const Json::exception& error) {
        refuse_json(path, error.what());
    }
    return figures;
}

std::vector<FigureMove> moves_between(const VersionFigures& before, const VersionFigures& now) {
    std::vector<FigureMove> moves;
    for (const auto& [name, figure] : now) {
        const auto former = before.find(name);
        if (former == before.end()) continue;
        const double noise = former->second.noise + figure.noise;
        const double difference = figure.value - former->second.value;
        if (std::abs(difference) <= noise) continue;
        moves.push_back({name, former->second.value, figure.value, noise,
                         (difference > 0.0) == figure.higher_is_better});
    }
    return moves;
}

}  // namespace lumi
