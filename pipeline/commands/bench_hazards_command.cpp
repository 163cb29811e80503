#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/commands/commands.h"
#include "pipeline/hazards/hazard_report.h"

namespace lumi {
namespace {

struct HazardsRequest {
    std::filesystem::path out;
    std::vector<std::string> hazards;
    std::vector<std::uint64_t> seeds{1};
    std::vector<std::size_t> steps;
    bool without_colmap = false;
};

std::vector<std::string> known_hazards() {
    std::vector<std::string> names;
    for (const HazardCurve& curve : hazard_curves()) names.push_back(curve.name);
    return names;
}

std::vector<const HazardCurve*> wanted_curves(const std::vector<std::string>& names) {
    std::vector<const HazardCurve*> curves;
    for (const HazardCurve& curve : hazard_curves()) {
        const bool is_named = std::find(names.begin(), names.end(), curve.name) != names.end();
        if (names.empty() || is_named) curves.push_back(&curve);
    }
    return curves;
}

struct HazardSetting {
    const HazardCurve* curve = nullptr;
    double strength = 0;
    std::uint64_t seed = 0;
};

std::vector<HazardSetting> wanted_settings(const HazardsRequest& request) {
    std::vector<HazardSetting> settings;
    for (const HazardCurve* const curve : wanted_curves(request.hazards)) {
        for (std::size_t step = 0; step < curve->strengths.size(); ++step) {
            const bool is_wanted =
                request.steps.empty() ||
                std::find(request.steps.begin(), request.steps.end(), step) != request.steps.end();
            if (!is_wanted) continue;
            for (const std::uint64_t seed : request.seeds) {
                settings.push_back({curve, curve->strengths[step], seed});
            }
        }
    }
    if (settings.empty()) {
        throw Error(ErrorKind::kUsage, "E-HAZARD-STEP", "--step: no hazard has such a strength",
                    "0 is the most harmless, 4 the most hopeless");
    }
    return settings;
}

void run_hazards(const HazardsRequest& request, const CommandContext& context) {
    require_writable_folder(request.out);
    TrialOptions options;
    options.with_colmap = !request.without_colmap;
    options.threads = context.threads > 0 ? context.threads : 1;
    const std::vector<HazardSetting> settings = wanted_settings(request);
    std::vector<Trial> trials;
    for (const HazardSetting& setting : settings) {
        trials.push_back(run_trial(setting.curve->hazard, setting.strength, setting.seed, options,
                                   request.out / "trial", *context.progress));
        context.say(std::to_string(trials.size()) + " of " + std::to_string(settings.size()) +
                    ": " + trial_text(trials.back()) + "\n");
        // After each, so that whoever stops a long run has what was measured.
        write_hazard_report(request.out, trials, *context.progress);
    }
    if (context.json) {
        context.print_result(hazards_json(trials));
    } else {
        context.print_result(hazards_text(trials) + (request.out / "hazards.svg").string() + "\n");
    }
}

}  // namespace

void add_bench_hazards_command(CLI::App& app, CommandContext& context) {
    CLI::App& command = add_command(
        app, "bench-hazards",
        "Drives the poses through what breaks them, from harmless to hopeless, on synthetic "
        "photographs; COLMAP alone beside it",
        "lumi bench-hazards --out work/hazards");
    const auto request = std::make_shared<HazardsRequest>();
    command.add_option("--out", request->out, "Folder for hazards.json, hazards.csv, hazards.svg")
        ->required();
    command.add_option("--hazard", request->hazards, "Only these")
        ->check(CLI::IsMember(known_hazards()));
    command.add_option("--seed", request->seeds, "One scene each")
        ->check(CLI::Range(0, std::numeric_limits<int>::max()))
        ->capture_default_str();
    command.add_option("--step", request->steps, "Only these strengths, 0: harmless");
    command.add_flag("--without-colmap", request->without_colmap, "Leaves out COLMAP alone");
    command.callback([request, &context] {
        context.chosen = [request, &context] { run_hazards(*request, context); };
    });
}

}  // namespace lumi
