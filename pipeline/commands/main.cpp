#include <glog/logging.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/process_memory.h"
#include "pipeline/commands/commands.h"
#include "pipeline/commands/error_report.h"
#include "pipeline/commands/interruption.h"
#include "pipeline/commands/unknown_word.h"
#include "pipeline/line/versions.h"

namespace {

void add_global_options(CLI::App& app, lumi::CommandContext& context) {
    app.add_flag("--json", context.json, "Results, and errors, as one JSON object on stdout");
    CLI::Option* quiet = app.add_flag("-q,--quiet", context.quiet, "No talk but errors");
    app.add_flag("-v,--verbose", context.verbosity,
                 "Of build and its stages: also what each stage found, as JSON")
        ->excludes(quiet);
    app.add_option("--threads", context.threads, "0: all cores")->check(CLI::Range(0, 4096));
    app.add_flag_callback(
        "--version", [] { throw CLI::CallForVersion(lumi::version_text(), 0); },
        "Versions of lumi and of what it is built from");
}

void add_commands(CLI::App& app, lumi::CommandContext& context) {
    lumi::add_build_command(app, context);
    lumi::add_calibrate_command(app, context);
    lumi::add_bench_boards_command(app, context);
    lumi::add_stage_commands(app, context);
    lumi::add_regression_command(app, context);
    lumi::add_doctor_command(app, context);
    lumi::add_render_command(app, context);
    lumi::add_view_command(app, context);
    lumi::add_bench_command(app, context);
    lumi::add_bench_depth_command(app, context);
    lumi::add_bench_poses_command(app, context);
    lumi::add_bench_flicker_command(app, context);
    lumi::add_bench_hazards_command(app, context);
    lumi::add_bench_mesh_command(app, context);
    lumi::add_bench_orbit_command(app, context);
    lumi::add_bench_rivals_command(app, context);
    lumi::add_evaluate_command(app, context);
    lumi::add_select_command(app, context);
    lumi::add_plan_command(app, context);
    lumi::add_chart_command(app, context);
    lumi::add_compare_evaluations_command(app, context);
    lumi::add_compare_pictures_command(app, context);
    lumi::add_compare_poses_command(app, context);
    lumi::add_fuse_command(app, context);
    lumi::add_gallery_command(app, context);
    lumi::add_inspect_command(app, context);
    lumi::add_validate_command(app, context);
    lumi::add_stress_command(app, context);
    lumi::add_synth_command(app, context);
}

/// An empty text comes of a variable of the shell that is not set: no option means anything by it.
void refuse_empty_texts(CLI::App& app) {
    const auto complaint = [](const std::string& text) -> std::string {
        return text.empty() ? "expected a value, found an empty one" : "";
    };
    for (CLI::Option* option : app.get_options()) {
        if (option->get_items_expected_max() > 0) option->check(complaint);
    }
    for (CLI::App* below : app.get_subcommands({})) refuse_empty_texts(*below);
}

/// For help, which is text also with --json, and for the version.
int answer_early(const CLI::App& app, const CLI::ParseError& answer,
                 lumi::CommandContext& context) {
    context.json = app.count("--json") > 0 && answer.get_name() == "CallForVersion";
    if (!context.json) return app.exit(answer);
    const nlohmann::ordered_json version{{"version", lumi::version_text()}};
    return lumi::run_and_report_errors([&] { context.print_result(version); }, context);
}

[[noreturn]] void refuse_line(const CLI::App& app, const std::string& reason) {
    if (const auto unknown = lumi::error_of_unknown_word(app)) throw *unknown;
    throw lumi::Error(lumi::ErrorKind::kUsage, "E-USAGE", reason,
                      "see `lumi --help`, or --help behind the name of a command");
}

}  // namespace

int main(int argc, char** argv) {
    // Ceres tells by its return values; its log would talk between ours.
    FLAGS_minloglevel = google::GLOG_FATAL;
    lumi::keep_little_free_memory();
    lumi::CommandContext context;
    CLI::App app{
        "Example: lumi build photos/ && lumi view work/photos/photos.lumi\n\n"
        "lumi turns photographs into a free-form Lumigraph and draws it from anywhere.",
        "lumi"};
    app.require_subcommand(1);
    app.fallthrough();
    add_global_options(app, context);
    add_commands(app, context);
    refuse_empty_texts(app);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& wrong) {
        if (wrong.get_exit_code() == 0) return answer_early(app, wrong, context);
        context.json = app.count("--json") > 0;  // A line that is wrong sets no flag.
        return lumi::run_and_report_errors([&] { refuse_line(app, wrong.what()); }, context);
    }
    const auto run_chosen = [&] {
        lumi::start_progress(context);
        const lumi::Interruption interruption(*context.progress);
        context.chosen();
    };
    const int failure = lumi::run_and_report_errors(run_chosen, context);
    return failure != 0 ? failure : context.exit_code;
}
