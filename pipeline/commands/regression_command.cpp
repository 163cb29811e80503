#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>
#include <optional>

#include "calib/work/counted.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/regression/version_figures.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct RegressionRequest {
    fs::path workspace;
    fs::path baseline;
    fs::path write;
    int frames = 20;
    int rounds = 3;
};

Json moves_json(const std::vector<FigureMove>& moves) {
    Json list = Json::array();
    for (const FigureMove& move : moves) {
        list.push_back({{"name", move.name},
                        {"before", move.before},
                        {"now", move.now},
                        {"noise", move.noise},
                        {"is", move.is_better ? "better" : "worse"}});
    }
    return list;
}

Json regression_json(const MeasuredVersion& now, const FigureComparison& comparison) {
    Json json = version_json(now);
    json["compared"] = comparison.compared;
    json["moves"] = moves_json(comparison.moves);
    json["only_in_baseline"] = comparison.only_before;
    json["only_now"] = comparison.only_now;
    return json;
}

std::string regression_text(const FigureComparison& comparison) {
    std::string text = counted(comparison.compared, "figure") + " compared, " +
                       std::to_string(comparison.moves.size()) + " moved beyond noise\n";
    for (const FigureMove& move : comparison.moves) {
        text += padded_right(move.name, 40) + padded_left(number_text(move.before, 4), 10) + " ->" +
                padded_left(number_text(move.now, 4), 10) + "  (noise " +
                number_text(move.noise, 4) + ")  " + (move.is_better ? "better" : "worse") + "\n";
    }
    for (const std::string& name : comparison.only_before) {
        text += padded_right(name, 40) + "  only in the baseline\n";
    }
    for (const std::string& name : comparison.only_now) {
        text += padded_right(name, 40) + "  not in the baseline\n";
    }
    return text;
}

void compare(const MeasuredVersion& before, const MeasuredVersion& now, const fs::path& baseline,
             const CommandContext& context) {
    const FigureComparison comparison = compare_figures(before.figures, now.figures);
    if (context.json) {
        context.print_result(regression_json(now, comparison));
    } else {
        context.print_result(regression_text(comparison));
    }
    refuse_regression(comparison, baseline);
}

void run_regression(const RegressionRequest& request, const CommandContext& context) {
    if (!request.write.empty()) require_writable_file(request.write);
    const WorkspaceLayout workspace = find_workspace(request.workspace);
    // Read before anything is written: figures may take the place of those they are compared with.
    std::optional<MeasuredVersion> baseline;
    if (!request.baseline.empty()) {
        baseline = read_version(request.baseline);
        expect_same_timing(*baseline, request.frames, request.rounds, request.baseline);
        expect_same_scene(baseline->scene, scene_to_measure(workspace, context.threads),
                          request.baseline);
    }
    const MeasuredVersion version = measure_version(workspace, request.frames, request.rounds,
                                                    context.threads, *context.progress);
    if (!request.write.empty()) write_json_file(request.write, version_json(version));
    if (baseline) {
        compare(*baseline, version, request.baseline, context);
    } else {
        context.print_result(version_json(version));
    }
}

}  // namespace

void add_regression_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "regression",
        "Errors and frame-time ratios of this version, and what moved against a baseline",
        "lumi regression work/demo --baseline configs/bench-baseline.json");
    const auto request = std::make_shared<RegressionRequest>();
    command.add_option("WORKSPACE", request->workspace, "Folder that lumi build wrote")->required();
    command.add_option("--baseline", request->baseline,
                       "Figures of another version, of the same photographs");
    command.add_option(
        "--write", request->write,
        "Where to write this version's figures; may be the baseline, which is compared with "
        "as it was");
    command.add_option("--frames", request->frames, "Along a path from view to view")
        ->check(CLI::Range(2, 100000))
        ->capture_default_str();
    command.add_option("--rounds", request->rounds, "Repetitions of the frame times")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_regression(*request, context); };
    });
}

}  // namespace lumi
