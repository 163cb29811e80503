#include <CLI/CLI.hpp>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/view_curve_plots.h"
#include "pipeline/commands/commands.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/evaluate/view_curve.h"
#include "pipeline/stages/mesh_stage.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/text/number_text.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json curve_json(const ViewCurve& curve) {
    Json points = Json::array();
    for (const ViewCurvePoint& point : curve.points) {
        points.push_back({{"views", point.views},
                          {"psnr_db", point.psnr_db},
                          {"texture_mib", point.texture_mib},
                          {"ms", point.ms},
                          {"random_psnr_db", point.random_psnr_db},
                          {"random_deviation_db", point.random_deviation_db},
                          {"best_random_psnr_db", point.best_random_psnr_db}});
    }
    return Json{{"auto_views", curve.auto_views},
                {"third_db_views", curve.third_db_views},
                {"ranking_cpu_s", curve.ranking_cpu_s},
                {"curve", std::move(points)}};
}

std::string curve_text(const ViewCurve& curve) {
    std::string text = "views   PSNR dB   MiB     ms    random choices: mean, deviation, best dB\n";
    for (const ViewCurvePoint& point : curve.points) {
        text += std::to_string(point.views) + "  " + number_text(point.psnr_db, 2) + "  " +
                number_text(point.texture_mib, 1) + "  " + number_text(point.ms, 1);
        if (point.random_psnr_db > 0) {
            text += "  " + number_text(point.random_psnr_db, 2) + "  " +
                    number_text(point.random_deviation_db, 2) + "  " +
                    number_text(point.best_random_psnr_db, 2);
        }
        text += "\n";
    }
    return text + "enough by the one-standard-error rule: " + counted(curve.auto_views, "view") +
           "; within 0.3 dB of the best: " + counted(curve.third_db_views, "view") + "\n";
}

void check_sizes(const std::vector<int>& sizes, std::size_t views) {
    for (const int size : sizes) {
        if (static_cast<std::size_t>(size) <= views) continue;
        throw Error(
            ErrorKind::kUsage, "E-SELECT-SIZE",
            "--size " + std::to_string(size) + ": the package has " + counted(views, "view"),
            "ask for at most all of them");
    }
}

void run_select(const std::filesystem::path& folder, ViewCurveOptions options,
                const std::filesystem::path& chart, const CommandContext& context) {
    if (!chart.empty()) require_writable_folder(chart);
    const WorkspaceLayout workspace = find_workspace(folder);
    options.mesh = camera_mesh_options_of(workspace);
    const PackRecord record = finished_pack(workspace);
    const Lumigraph lumigraph = read_package(workspace.package_folder());
    check_sizes(options.sizes, lumigraph.views.size());
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    std::sort(names.begin(), names.end());
    const Capture capture =
        only_views(packed_photographs(workspace, record, context.threads), names).capture;
    const ViewCurve curve = measure_view_curve(
        lumigraph, capture, held_out_photographs(workspace, record, context.threads), options,
        *context.progress);
    if (!chart.empty()) draw_view_curve(chart, curve, *context.progress);
    if (context.json) {
        context.print_result(curve_json(curve));
    } else {
        context.print_result(curve_text(curve));
    }
}

}  // namespace

void add_select_command(CLI::App& app, CommandContext& context) {
    CLI::App& command =
        add_command(app, "select", "How many views are enough: dB, MiB and ms against their number",
                    "lumi select work/miku");
    const auto folder = std::make_shared<std::filesystem::path>();
    const auto options = std::make_shared<ViewCurveOptions>();
    command.add_option("WORKSPACE", *folder, "Folder that lumi build wrote")->required();
    command.add_option("--least", options->least_views, "Fewest views to try")
        ->check(CLI::Range(1, 10000))
        ->capture_default_str();
    command
        .add_option("--size", options->sizes,
                    "Numbers of views to try; by default each time a quarter less")
        ->check(CLI::Range(1, 10000));
    command
        .add_option("--random", options->random_choices,
                    "Random choices at each number, to compare with")
        ->check(CLI::Range(0, 1000))
        ->capture_default_str();
    const auto chart = std::make_shared<std::filesystem::path>();
    command.add_option("--chart", *chart, "Draw the curve into this folder: dB, MiB, ms");
    command.callback([folder, options, chart, &context] {
        context.chosen = [folder, options, chart, &context] {
            run_select(*folder, *options, *chart, context);
        };
    });
}

}  // namespace lumi
