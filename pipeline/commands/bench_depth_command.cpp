#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "meshing/depth_models/depth_model.h"
#include "meshing/surface/mesh_io.h"
#include "pipeline/commands/commands.h"
#include "pipeline/depth_bench/rung_chart.h"
#include "pipeline/depth_bench/stability_report.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/straightened_depth.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/text/number_text.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

struct BenchDepthRequest {
    std::vector<fs::path> workspaces;
    fs::path out;
    std::vector<std::string> models;
    fs::path truth_folder;
    int max_width_px = DepthOptions{}.max_width_px;
    bool stability = false;
    bool quick = false;
    std::vector<std::string> hazards;
    std::vector<std::uint64_t> seeds{1};
};

/// The views that a built workspace uses and holds out, as its package was made. Exact depth may be
/// straightened in `scratch`.
DepthBenchScene scene_of(const WorkspaceLayout& workspace, const BenchDepthRequest& request,
                         const fs::path& scratch, const CommandContext& context) {
    const PackRecord record = finished_pack(workspace);
    const PosedPhotographs all =
        read_posed_photographs(workspace.stage_folder("poses") / "pinhole");
    DepthBenchScene scene{workspace.name(), without_views(all, record.held_out),
                          only_views(all, record.held_out),
                          read_camera_mesh_ply(workspace.stage_folder("mesh") / "camera_mesh.ply")};
    if (!request.truth_folder.empty()) {
        scene.truth_folder = request.truth_folder;
        scene.truth_files = straighten_depth({request.truth_folder}, scene.used.capture,
                                             workspace.stage_folder("poses"), scratch,
                                             context.threads, *context.progress);
    }
    return scene;
}

std::string line_of(const RungMeasurement& rung) {
    return rung.scene + "  " + rung.model + "  " + number_text(rung.cpu_s_per_megapixel, 3) +
           " CPU s per megapixel  RMS " + number_text(rung.rms_error, 2) + " +- " +
           number_text(rung.rms_standard_error, 2) + "  covered " +
           (rung.held_out.psnr_covered_db ? number_text(*rung.held_out.psnr_covered_db, 2)
                                          : "none") +
           " dB of " + number_text(100 * rung.held_out.coverage, 1) + " %  full " +
           number_text(rung.held_out.psnr_db, 2) + " dB" +
           (rung.right_share ? "  right " + number_text(100 * *rung.right_share, 1) + " %"
                             : std::string()) +
           (rung.right_visible_share
                ? " (of visible texture " + number_text(100 * *rung.right_visible_share, 1) + " %)"
                : std::string()) +
           (rung.peak_mib ? "  " + number_text(*rung.peak_mib, 0) + " MiB (" +
                                number_text(rung.expected_peak_mib, 0) + " expected)"
                          : std::string()) +
           (rung.choice.empty() ? "" : "  " + rung.choice) + "\n";
}

/// The rungs, and what chooses among them.
std::vector<std::string> model_names() {
    std::vector<std::string> names = depth_model_names();
    names.push_back("auto");
    return names;
}

/// Those of `known` that are asked for, each once; all of them where none is.
std::vector<std::string> wanted_of(const std::vector<std::string>& known,
                                   const std::vector<std::string>& asked) {
    std::vector<std::string> wanted;
    std::copy_if(known.begin(), known.end(), std::back_inserter(wanted), [&](const auto& name) {
        return asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
    });
    return wanted;
}

void run_bench_depth(const BenchDepthRequest& request, const CommandContext& context) {
    std::vector<RungMeasurement> measured;
    for (const fs::path& folder : request.workspaces) {
        const WholeFolder scratch(request.out / "truth");
        const DepthBenchScene scene =
            scene_of(find_workspace(folder), request, scratch.staging(), context);
        for (const std::string& model : request.models) {
            DepthOptions options;
            options.model = model;
            options.max_width_px = request.max_width_px;
            measured.push_back(measure_rung(
                scene, options, context.threads, [](RenderMode, const JudgedView&) {},
                *context.progress));
            if (!context.json) context.print_result(line_of(measured.back()));
        }
    }
    write_rung_chart(request.out, measured, *context.progress);
    if (context.json) context.print_result(rungs_json(measured));
    context.say((request.out / "rungs.svg").string() + "\n");
}

std::vector<std::string> hazard_names() {
    std::vector<std::string> names;
    for (const DepthHazardCurve& curve : depth_hazard_curves()) names.push_back(curve.name);
    return names;
}

struct StabilitySetting {
    DepthHazard hazard;
    double strength;
    std::uint64_t seed;
};

std::vector<StabilitySetting> wanted_settings(const BenchDepthRequest& request) {
    std::vector<StabilitySetting> settings;
    for (const DepthHazardCurve& curve : depth_hazard_curves()) {
        const bool is_wanted =
            request.hazards.empty() || std::find(request.hazards.begin(), request.hazards.end(),
                                                 curve.name) != request.hazards.end();
        if (!is_wanted) continue;
        for (std::size_t i = 0; i < curve.strengths.size(); i += request.quick ? 2 : 1) {
            for (const std::uint64_t seed : request.seeds) {
                settings.push_back({curve.hazard, curve.strengths[i], seed});
            }
        }
    }
    return settings;
}

void run_stability(const BenchDepthRequest& request, const CommandContext& context) {
    const std::vector<StabilitySetting> settings = wanted_settings(request);
    std::vector<StabilityTrial> trials;
    for (const StabilitySetting& setting : settings) {
        trials.push_back(stability_trial(setting.hazard, setting.strength, setting.seed,
                                         request.models, request.out / "trial", context.threads,
                                         *context.progress));
        context.say(std::to_string(trials.size()) + " of " + std::to_string(settings.size()) +
                    ": " + stability_row(trials.back()) + "\n");
        // After each, so that whoever stops a long run has what was measured.
        write_stability_report(request.out, trials, *context.progress);
    }
    if (context.json) {
        context.print_result(stability_json(trials));
    } else {
        context.print_result(stability_text(trials));
    }
    context.say((request.out / "stability.csv").string() + "\n");
}

/// The rungs, and "auto" where workspaces are measured: on synthetic scenes it is one of them.
void run(BenchDepthRequest request, const CommandContext& context) {
    if (request.stability == !request.workspaces.empty()) {
        throw Error(ErrorKind::kUsage, "E-BENCH-DEPTH",
                    "bench-depth: expected workspaces or --stability, found " +
                        std::string(request.stability ? "both" : "neither"),
                    "see lumi bench-depth --help");
    }
    request.models = request.models.empty() && request.stability
                         ? depth_model_names()
                         : wanted_of(model_names(), request.models);
    require_writable_folder(request.out);
    if (request.stability) {
        run_stability(request, context);
    } else {
        run_bench_depth(request, context);
    }
}

}  // namespace

void add_bench_depth_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "bench-depth",
        "What each depth model costs and brings, on built workspaces; or how it stands what makes "
        "depth hard to find, from harmless to hopeless, on synthetic scenes",
        "lumi bench-depth work/fountain work/kettle --out work/depth-chart\n"
        "         lumi bench-depth --stability --out work/depth-stability");
    const auto request = std::make_shared<BenchDepthRequest>();
    command.add_option("WORKSPACES", request->workspaces, "Folders that lumi build wrote");
    command
        .add_option("--out", request->out,
                    "Folder for rungs.svg, rungs.csv and rungs.json, or for stability.json, "
                    "stability.csv and a chart of each hazard")
        ->required();
    command.add_option("--model", request->models, "Models to measure; may be repeated")
        ->allow_extra_args(false)
        ->check(CLI::IsMember(model_names()));
    command
        .add_option("--max-width", request->max_width_px, "Depth maps are at most this wide, px")
        ->check(CLI::Range(16, 16384));
    command.add_option("--truth", request->truth_folder,
                       "Folder of exact depth, by photograph, as its lens bent it");
    CLI::Option* const stability = command.add_flag(
        "--stability", request->stability, "Synthetic scenes under hazards instead of workspaces");
    command.add_option("--hazard", request->hazards, "Only this hazard; may be repeated")
        ->allow_extra_args(false)
        ->check(CLI::IsMember(hazard_names()))
        ->needs(stability);
    command.add_option("--seed", request->seeds, "One scene each")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()))
        ->capture_default_str()
        ->needs(stability);
    command.add_flag("--quick", request->quick, "Every other strength")->needs(stability);
    command.callback(
        [request, &context] { context.chosen = [request, &context] { run(*request, context); }; });
}

}  // namespace lumi
