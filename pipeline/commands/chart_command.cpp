#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "calib/work/counted.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/chart/chart_files.h"
#include "pipeline/chart/chart_folder.h"
#include "pipeline/chart/growth_files.h"
#include "pipeline/chart/run_sweep.h"
#include "pipeline/chart/sweep_plots.h"
#include "pipeline/commands/commands.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct ChartRequest {
    fs::path config;
    fs::path out;
    bool growth_alone = false;
};

std::string front_table(const ChartResult& result) {
    const std::vector<ChartPoint> points = points_of(result);
    std::string table = padded_left("CPU s", 9) + padded_left("ms", 9) + padded_left("MiB", 9) +
                        padded_left("FLIP", 9) + padded_left("dB", 8) + "  settings\n";
    for (const std::size_t index : front_by_build_time(points)) {
        const ChartPoint& point = points[index];
        table += padded_left(number_text(point.build_cpu_s, 1), 9) +
                 padded_left(number_text(point.frame_ms, 1), 9) +
                 padded_left(number_text(point.package_mib, 1), 9) +
                 padded_left(number_text(point.mean.flip, 4), 9) +
                 padded_left(number_text(point.mean.psnr_db, 2), 8) + "  " + point.label + "\n";
    }
    return table;
}

/// Where this program lies, to run stages in processes of their own.
fs::path this_program() { return fs::read_symlink("/proc/self/exe"); }

GrowthPlan wanted_growth(const ChartRequest& request, const ConfigDocument& document) {
    GrowthPlan plan = read_growth_plan(document);
    if (plan.is_empty() && request.growth_alone) {
        throw Error(ErrorKind::kUsage, "E-GROWTH-NOTHING",
                    request.config.string() + ": nothing to measure",
                    "add a table [growth] with photographs = [10, 30, 100]");
    }
    return plan;
}

/// Its samples and exponents; null where none is wanted.
Json measured_growth(const ConfigDocument& document, const GrowthPlan& plan, const fs::path& folder,
                     const CommandContext& context) {
    if (plan.is_empty()) return {};
    const WorkFolder held = take_chart_folder(folder);
    const GrowthResult growth = measure_growth(document, plan, this_program(), folder / "growth",
                                               context.threads, *context.progress);
    write_growth_files(folder, document.build_config_with({}).name, growth, *context.progress);
    context.say((folder / "growth.html").string() + "\n");
    return growth_json(growth);
}

/// Told before hours are spent on it.
std::string extent_of(const Sweep& sweep) {
    return counted(sweep.variants.size(), "setting") + ", each drawn in " +
           counted(sweep.modes.size(), "mode") +
           (sweep.is_default ? ": the default sweep, as there is no table [sweep]" : "") + "\n";
}

void run_chart(const ChartRequest& request, const CommandContext& context) {
    const Sweep sweep = read_sweep(request.config);
    const fs::path folder =
        request.out.empty() ? fs::path("work") / (sweep.name + "-chart") : request.out;
    require_writable_folder(folder);
    // Before hours are spent: what is wrong with it is said at once, and leaves the folder alone.
    const ConfigDocument document = ConfigDocument::open(request.config);
    const GrowthPlan plan = wanted_growth(request, document);
    if (request.growth_alone) {
        const Json growth = measured_growth(document, plan, folder, context);
        if (context.json) context.print_result(Json{{"growth", growth}});
        return;
    }
    context.say(extent_of(sweep));
    const ChartResult result = run_sweep(sweep, folder, context.threads, *context.progress);
    write_chart_files(folder, result, *context.progress);
    Json object = chart_json(result);
    // Told before growth is measured, which takes long and may be stopped.
    if (context.json) {
        context.print_result(object);
    } else {
        context.print_result(front_table(result));
    }
    if (Json growth = measured_growth(document, plan, folder, context);
        !growth.is_null() && context.json) {
        object["growth"] = std::move(growth);
        context.print_result(object);
    }
    context.say(number_text(100.0 * result.work.cached_share(), 0) +
                " % of the work came from the cache\n" + (folder / "chart.html").string() + "\n");
}

}  // namespace

void add_chart_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "chart", "Speed against accuracy: builds and measures every combination under [sweep]",
        "lumi chart configs/demo-chart.toml");
    const auto request = std::make_shared<ChartRequest>();
    command
        .add_option("CONFIG", request->config,
                    "Configuration file with a table [sweep], or a folder of photographs; without "
                    "a table every depth model is tried at three sizes of photographs")
        ->required();
    command.add_flag("--growth-alone", request->growth_alone,
                     "Only how time and memory grow, by the table [growth]");
    command.add_option("--out", request->out, "Where to work (default: work/NAME-chart)");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_chart(*request, context); };
    });
}

}  // namespace lumi
