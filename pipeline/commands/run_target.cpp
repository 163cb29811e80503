#include "pipeline/commands/run_target.h"

#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/error.h"
#include "pipeline/chart/chart_files.h"
#include "pipeline/chart/run_sweep.h"
#include "pipeline/commands/partial_build.h"
#include "pipeline/config/config_variant.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/line/chosen_workspace.h"
#include "pipeline/report/workspace_report.h"
#include "pipeline/target/candidates.h"
#include "pipeline/target/deliver.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::string told(const Delivery& delivery) {
    std::string text;
    for (const std::string& setting : delivery.settings) text += setting + "\n";
    return text + "draw with --mode " + name_of(delivery.chosen.mode) + "\n" + delivery.wish.text +
           ": the chart promised " + figure_text(delivery.wish, delivery.promised) +
           ", the package comes to " + figure_text(delivery.wish, delivery.delivered) + "\n";
}

}  // namespace

void run_target(const BuildRequest& request, const std::string& wish,
                const CommandContext& context) {
    const Wish wanted = wish_from(wish);
    Sweep sweep = read_sweep(request.config);
    put_cheapest_first(sweep);
    const BuildConfig config = ConfigDocument::open(request.config).build_config_with({});
    if (config.hold_out.every == 0 && config.hold_out.names.empty()) {
        throw Error(ErrorKind::kUsage, "E-EVAL-NOHOLDOUT",
                    request.config.string() + ": no photograph is held out to measure with",
                    "set hold_out_every = 8 under [evaluate] in the configuration");
    }
    // Before hours are spent: whoever else works there, or has files there, is heard first.
    const Workspace workspace(layout_for(request.workspace, config, context.threads));
    const fs::path chart_folder = workspace.folder().string() + "-chart";
    const int threads = context.threads > 0 ? context.threads : config.threads;
    const ChartResult chart =
        run_sweep(sweep, chart_folder, threads, *context.progress,
                  [&](const MeasuredVariant& variant) { return ends_the_sweep(wanted, variant); });
    write_chart_files(chart_folder, chart, *context.progress);
    std::optional<Delivery> made;
    work_and_report(workspace, [&] {
        made = deliver(wanted, chart, workspace, threads, *context.progress);
        nlohmann::ordered_json told_to_report = delivery_json(*made);
        told_to_report["package_sha256"] = package_sha256(workspace);
        write_json_file(workspace.folder() / "target.json", told_to_report);
    });
    const Delivery& delivery = *made;

    if (context.json) {
        context.print_result(delivery_json(delivery));
    } else {
        context.print_result(workspace.package_folder().string() + "\n" + told(delivery));
    }
    if (meets(delivery.wish, delivery.delivered))
        return refuse_partial(delivery.photographs, workspace);
    throw Error(ErrorKind::kPartialResult, "E-TARGET-MISSED",
                wish + " is out of reach: the nearest is " +
                    figure_text(delivery.wish, delivery.delivered) + " with " +
                    delivery.chosen.label,
                "wish for less, or try more values under [sweep]; " +
                    (chart_folder / "chart.html").string() + " shows what there is");
}

}  // namespace lumi
