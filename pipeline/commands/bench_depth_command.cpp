#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "meshing/depth/depth_model.h"
#include "meshing/surface/mesh_io.h"
#include "pipeline/commands/commands.h"
#include "pipeline/depth_bench/rung_chart.h"
#include "pipeline/report/number_text.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/stages/posed_files.h"
#include "pipeline/stages/used_views.h"
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
};

/// The views that a built workspace uses and holds out, as its package was made.
DepthBenchScene scene_of(const WorkspaceLayout& workspace, const fs::path& truth_folder) {
    const PackRecord record = read_pack_record(workspace.stage_folder("pack"));
    if (record.held_out.empty()) {
        throw Error(
            ErrorKind::kUsage, "E-EVAL-NOHOLDOUT",
            workspace.folder().string() + ": no photograph was held out",
            "set hold_out_every = 8 under [evaluate] in the configuration, and build again");
    }
    const PosedPhotographs all =
        read_posed_photographs(workspace.stage_folder("poses") / "pinhole");
    return {workspace.name(), without_views(all, record.held_out), only_views(all, record.held_out),
            read_camera_mesh_ply(workspace.stage_folder("mesh") / "camera_mesh.ply"), truth_folder};
}

std::string line_of(const RungMeasurement& rung) {
    return rung.scene + "  " + rung.model + "  " + number_text(rung.cpu_s_per_megapixel, 3) +
           " CPU s per megapixel  RMS " + number_text(rung.rms_error, 2) + " +- " +
           number_text(rung.rms_standard_error, 2) + "  covered " +
           (rung.held_out.psnr_covered_db ? number_text(*rung.held_out.psnr_covered_db, 2)
                                          : "none") +
           " dB  full " + number_text(rung.held_out.psnr_db, 2) + " dB" +
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

void run_bench_depth(const BenchDepthRequest& request, const CommandContext& context) {
    std::vector<RungMeasurement> measured;
    for (const fs::path& folder : request.workspaces) {
        const DepthBenchScene scene = scene_of(find_workspace(folder), request.truth_folder);
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

}  // namespace

void add_bench_depth_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "bench-depth", "What each depth model costs and brings, on built workspaces",
        "lumi bench-depth work/fountain work/kettle --out work/depth-chart");
    const auto request = std::make_shared<BenchDepthRequest>();
    request->models = model_names();
    command.add_option("WORKSPACES", request->workspaces, "Folders that lumi build wrote")
        ->required();
    command.add_option("--out", request->out, "Folder for rungs.svg, rungs.csv and rungs.json")
        ->required();
    command.add_option("--model", request->models, "Models to measure; may be repeated")
        ->allow_extra_args(false)
        ->check(CLI::IsMember(model_names()));
    command.add_option("--max-width", request->max_width_px,
                       "Depth maps are at most this wide, px");
    command.add_option("--truth", request->truth_folder, "Folder of exact depth, by photograph");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_bench_depth(*request, context); };
    });
}

}  // namespace lumi
