#include "pipeline/commands/run_perturbations.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/whole_file.h"
#include "pipeline/config/config_variant.h"
#include "pipeline/line/chosen_workspace.h"
#include "pipeline/line/line.h"
#include "pipeline/stress/perturbation.h"
#include "pipeline/stress/stress_files.h"
#include "pipeline/stress/stress_subject.h"
#include "pipeline/text/number_text.h"
#include "pipeline/text/padded.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// What is stressed, how, and where the results go unless the command line says otherwise.
struct StressTask {
    StressSubject subject;
    StressOptions options;
    fs::path package;
    fs::path out;
};

bool has(const fs::path& folder, const char* name) {
    std::error_code status;
    return fs::is_regular_file(folder / name, status);
}

StressOptions default_options() {
    return read_stress_options(ConfigSection::from_text("", "(defaults)"));
}

StressTask task_of(const fs::path& path, const CommandContext& context) {
    if (has(path, kManifestName)) {
        fs::path name = fs::absolute(path).lexically_normal();
        if (!name.has_filename()) name = name.parent_path();
        return {subject_of_package(path), default_options(), path,
                fs::path("work") / (name.stem().string() + "-stress")};
    }
    if (has(path, "config.toml") && has(path, "stages.json")) {
        const WorkspaceLayout workspace = find_workspace(path);
        return {subject_of_workspace(workspace, context.threads), default_options(),
                workspace.package_folder(), path / "stress"};
    }
    const ConfigDocument document = ConfigDocument::open(path);
    StressOptions options = read_stress_options(document.options_of("stress"));
    const BuildConfig config = document.build_config_with({});
    const int threads = context.threads > 0 ? context.threads : config.threads;
    const Workspace workspace(layout_for({}, config, threads));
    static_cast<void>(run_line(config, workspace, "pack", threads, *context.progress));
    return {subject_of_workspace(workspace, threads), std::move(options),
            workspace.package_folder(), workspace.folder() / "stress"};
}

std::string table_of(const StressResult& result) {
    std::size_t width = 0;
    for (const StressCurve& curve : result.curves)
        width = std::max(width, words_of_perturbation(curve.perturbation).size() + 2);
    std::string table = padded_right("what is wrong", width) + padded_right("mode", 14) +
                        padded_left("without, dB", 12) + padded_left("at worst, dB", 14) +
                        "   costs " + number_text(result.max_loss_db, 1) + " dB at\n";
    for (const StressCurve& curve : result.curves) {
        table += padded_right(words_of_perturbation(curve.perturbation), width) +
                 padded_right(name_of(curve.mode), 14) +
                 padded_left(number_text(curve.psnr_db.front(), 2), 12) +
                 padded_left(number_text(curve.psnr_db.back(), 2), 14) + "   " +
                 (curve.breaking_point ? number_text(*curve.breaking_point, 3)
                                       : "beyond " + number_text(curve.strengths.back(), 1)) +
                 "\n";
    }
    return table;
}

}  // namespace

void run_perturbations(const PerturbationRequest& request, const CommandContext& context) {
    if (!request.out.empty()) require_writable_folder(request.out);
    const StressTask task = task_of(request.subject, context);
    const fs::path out = request.out.empty() ? task.out : request.out;
    if (request.out.empty()) require_writable_folder(out);
    StressResult result;
    result.name = task.subject.lumigraph.name;
    result.package_sha256 = sha256_hex_of_file(task.package / kManifestName);
    result.seed = task.options.seed;
    result.max_loss_db = task.options.max_loss_db;
    result.views_are_held_out = task.subject.views_are_held_out;
    for (const StressView& view : task.subject.views) result.views.push_back(view.name);
    result.curves = stress_curves(task.subject, task.options, *context.progress);
    write_stress_files(out, result, *context.progress);
    if (context.json) {
        context.print_result(stress_json(result));
    } else {
        context.print_result(table_of(result));
    }
    context.say((out / "stress.html").string() + "\n");
}

}  // namespace lumi
