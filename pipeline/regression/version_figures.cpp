#include "pipeline/regression/version_figures.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/median.h"
#include "pipeline/evaluate/evaluation.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/workspace/json_file.h"
#include "render/bench/frame_timing.h"
#include "render/lumigraph/package.h"
#include "render/paths/path_through_views.h"
#include "render/paths/photograph_eye.h"

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
            const bool is_time = name == "ms" || name == "cpu_ms";
            if (!mean || is_time || name == "ghost_energy") continue;
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
        const double median = median_of(values);
        const auto [least, most] = std::minmax_element(values.begin(), values.end());
        figures["ratio." + name_of(mode)] = {median, (*most - *least) / 2.0 + kTimeNoise * median,
                                             false};
    }
}

/// Nothing within the noise of both. A figure that is no number is worse.
std::optional<FigureMove> move_of(const std::string& name, const VersionFigure& before,
                                  const VersionFigure& now) {
    const double noise = before.noise + now.noise;
    const double difference = now.value - before.value;
    if (std::abs(difference) <= noise) return std::nullopt;
    const bool is_better = now.higher_is_better ? difference > 0.0 : difference < 0.0;
    return FigureMove{name, before.value, now.value, noise, is_better};
}

MeasuredScene scene_of(const std::string& name, const PosedPhotographs& held_out) {
    MeasuredScene scene{name, 0, 0, {}};
    for (const View& view : held_out.capture.views) {
        // Cameras of the capture may be those of other photographs, too.
        const Camera& camera = camera_of(held_out.capture, view);
        scene.width_px = std::max(scene.width_px, camera.width_px);
        scene.height_px = std::max(scene.height_px, camera.height_px);
        scene.views.push_back(view.name);
    }
    return scene;
}

[[noreturn]] void refuse_other(const std::filesystem::path& baseline, const std::string& what) {
    throw Error(ErrorKind::kUsage, "E-REGRESSION-OTHER", baseline.string() + ": " + what,
                "measure the workspace that the baseline is of, or write a new baseline with "
                "--write");
}

std::string text_of(const MeasuredScene& scene) {
    return scene.name + " (" + std::to_string(scene.width_px) + "x" +
           std::to_string(scene.height_px) + ", " + listed_names(scene.views) + ")";
}

/// Lists of names are shortened, so that two may read alike.
std::string first_difference(const std::vector<std::string>& before,
                             const std::vector<std::string>& now) {
    const auto [left, right] = std::mismatch(before.begin(), before.end(), now.begin(), now.end());
    if (left == before.end() && right == now.end()) return "";
    const auto named = [](const auto& name, const std::vector<std::string>& names) {
        return name == names.end() ? std::string("nothing") : *name;
    };
    return ": " + named(left, before) + " stands there, and here " + named(right, now);
}

std::string timing_text(int frames, int rounds) {
    return "--frames " + std::to_string(frames) + " --rounds " + std::to_string(rounds);
}

std::string missing_text(const std::vector<std::string>& names) {
    constexpr std::size_t kMaxNamed = 4;
    if (names.empty()) return "";
    std::string text = ", not " + names.front();
    for (std::size_t i = 1; i < std::min(kMaxNamed, names.size()); ++i) text += ", " + names[i];
    if (names.size() > kMaxNamed) {
        text += " and " + std::to_string(names.size() - kMaxNamed) + " more";
    }
    return text;
}

}  // namespace

MeasuredScene scene_to_measure(const WorkspaceLayout& workspace, int threads) {
    return scene_of(workspace.name(), held_out_photographs(workspace, threads));
}

MeasuredVersion measure_version(const WorkspaceLayout& workspace, int frames, int rounds,
                                int threads, Progress& progress) {
    const PosedPhotographs held_out = held_out_photographs(workspace, threads);
    const Lumigraph lumigraph = read_package(workspace.package_folder());
    const std::vector<RenderMode> modes = all_render_modes();
    MeasuredVersion version{scene_of(workspace.name(), held_out), frames, rounds, {}};
    append_errors(version.figures, evaluate_held_out(
                                       lumigraph, held_out,
                                       {.modes = modes, .ghost_energy = false, .timed_frames = 1},
                                       [](RenderMode, const JudgedView&) {}, progress));
    append_ratios(version.figures, lumigraph, modes, frames, rounds, progress);
    return version;
}

Json version_json(const MeasuredVersion& version) {
    Json list = Json::object();
    for (const auto& [name, figure] : version.figures) {
        list[name] = {{"value", figure.value},
                      {"noise", figure.noise},
                      {"higher_is_better", figure.higher_is_better}};
    }
    return Json{{"schema_version", kSchemaVersion},
                {"name", version.scene.name},
                {"size", {version.scene.width_px, version.scene.height_px}},
                {"views", version.scene.views},
                {"frames", version.frames},
                {"rounds", version.rounds},
                {"figures", std::move(list)}};
}

MeasuredVersion read_version(const std::filesystem::path& path) {
    const Json json = read_json_file(path);
    MeasuredVersion version;
    try {
        if (json.at("schema_version") != kSchemaVersion) refuse_json(path, "another version");
        if (!json.contains("views")) refuse_other(path, "does not say which scene it is of");
        version.scene = {json.at("name"), json.at("size").at(0), json.at("size").at(1),
                         json.at("views").get<std::vector<std::string>>()};
        version.frames = json.at("frames");
        version.rounds = json.at("rounds");
        for (const auto& [name, figure] : json.at("figures").items()) {
            version.figures[name] = {figure.at("value"), figure.at("noise"),
                                     figure.at("higher_is_better")};
        }
    } catch (const Json::exception& error) {
        refuse_json(path, error);
    }
    return version;
}

void expect_same_timing(const MeasuredVersion& before, int frames, int rounds,
                        const std::filesystem::path& baseline) {
    if (before.frames == frames && before.rounds == rounds) return;
    throw Error(ErrorKind::kUsage, "E-REGRESSION-OTHER",
                baseline.string() + ": was measured with " +
                    timing_text(before.frames, before.rounds) + ", and not with " +
                    timing_text(frames, rounds),
                "say the same, or write a new baseline with --write");
}

void expect_same_scene(const MeasuredScene& before, const MeasuredScene& now,
                       const std::filesystem::path& baseline) {
    if (before == now) return;
    refuse_other(baseline, "is of " + text_of(before) + ", and not of " + text_of(now) +
                               first_difference(before.views, now.views));
}

FigureComparison compare_figures(const VersionFigures& before, const VersionFigures& now) {
    FigureComparison result;
    for (const auto& [name, figure] : before) {
        if (!now.contains(name)) result.only_before.push_back(name);
    }
    for (const auto& [name, figure] : now) {
        const auto former = before.find(name);
        if (former == before.end()) {
            result.only_now.push_back(name);
            continue;
        }
        ++result.compared;
        if (auto move = move_of(name, former->second, figure)) result.moves.push_back(*move);
    }
    return result;
}

void refuse_regression(const FigureComparison& comparison, const std::filesystem::path& baseline) {
    const auto worse = std::count_if(comparison.moves.begin(), comparison.moves.end(),
                                     [](const FigureMove& move) { return !move.is_better; });
    if (worse > 0) {
        throw Error(ErrorKind::kPartialResult, "E-REGRESSION-WORSE",
                    counted(worse, "figure") + (worse == 1 ? " is" : " are") + " worse than in " +
                        baseline.string(),
                    "find out what changed, or write a new baseline with --write");
    }
    if (comparison.compared > 0 && comparison.only_before.empty()) return;
    throw Error(ErrorKind::kPartialResult, "E-REGRESSION-MISSING",
                baseline.string() + ": " + std::to_string(comparison.compared) + " of its " +
                    std::to_string(comparison.compared + comparison.only_before.size()) +
                    " figures were measured again" + missing_text(comparison.only_before),
                "measure the workspace that the baseline is of, or write a new baseline with "
                "--write");
}

}  // namespace lumi
