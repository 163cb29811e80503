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
#include "pipeline/text/padded.h"
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

std::string curve_row(const std::vector<std::string>& cells) {
    constexpr std::size_t kWidth = 10;
    std::string row;
    for (const std::string& cell : cells) row += padded_left(cell, kWidth);
    return row + "\n";
}

std::string curve_text(const ViewCurve& curve) {
    const bool has_random = std::any_of(curve.points.begin(), curve.points.end(),
                                        [](const auto& point) { return point.random_psnr_db > 0; });
    std::vector<std::string> head{"views", "PSNR dB", "MiB", "ms"};
    if (has_random) head.insert(head.end(), {"random dB", "deviation", "best dB"});
    std::string text = curve_row(head);
    for (const ViewCurvePoint& point : curve.points) {
        std::vector<std::string> cells{std::to_string(point.views), number_text(point.psnr_db, 2),
                                       number_text(point.texture_mib, 1), number_text(point.ms, 1)};
        if (point.random_psnr_db > 0) {
            cells.insert(cells.end(), {number_text(point.random_psnr_db, 2),
                                       number_text(point.random_deviation_db, 2),
                                       number_text(point.best_random_psnr_db, 2)});
        }
        text += curve_row(cells);
    }
    return text + "enough by the one-standard-error rule: " + counted(curve.auto_views, "view") +
           "; within 0.3 dB of the best: " + counted(curve.third_db_views, "view") + "\n";
}

void expect_at_most(const std::string& option, int asked, std::size_t views) {
    if (static_cast<std::size_t>(asked) <= views) return;
    throw Error(
        ErrorKind::kUsage, "E-SELECT-SIZE",
        option + " " + std::to_string(asked) + ": the package has " + counted(views, "view"),
        "ask for at most all of them");
}

void run_select(const std::filesystem::path& folder, ViewCurveOptions options,
                const std::filesystem::path& chart, const CommandContext& context) {
    if (!chart.empty()) require_writable_folder(chart);
    const WorkspaceLayout workspace = find_workspace(folder);
    options.mesh = camera_mesh_options_of(workspace.config_path());
    const PackRecord record = finished_pack(workspace);
    const Lumigraph lumigraph = read_package(workspace.package_folder());
    for (const int size : options.sizes) expect_at_most("--size", size, lumigraph.views.size());
    // The default is no wish: of fewer views than that, all are tried.
    if (options.least_views != ViewCurveOptions{}.least_views)
        expect_at_most("--least", options.least_views, lumigraph.views.size());
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    std::sort(names.begin(), names.end());
    const Capture capture =
        only_views(packed_photographs(workspace, record, context.threads), names).capture;
    const ViewCurve curve = measure_view_curve(
        lumigraph, capture, held_out_photographs(workspace, record, context.threads), options,
        context.threads, *context.progress);
    if (!chart.empty()) {
        for (const std::filesystem::path& picture :
             draw_view_curve(chart, curve, *context.progress))
            context.say(picture.string() + "\n");
    }
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
