#include "pipeline/workspace/stage_cache.h"

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "calib/ingest/made_by_lumi.h"
#include "calib/work/stopwatch.h"
#include "calib/work/whole_folder.h"
#include "pipeline/workspace/stage_outputs.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// Empty when what stands in the workspace can stay.
std::string reason_to_run(const StageIdentity& now, const std::optional<DoneMarker>& before,
                          const fs::path& workspace_folder, int threads) {
    if (!before) return "not done before";
    const StageIdentity& then = before->identity;
    if (then.code != now.code) return "lumi changed";
    if (then.external_tool != now.external_tool) return "external program changed";
    if (then.parameters != now.parameters) return "parameters changed";
    if (then.inputs != now.inputs) return "inputs changed";
    if (stage_key(then) != stage_key(now)) return "another stage's result";
    if (!are_unharmed(workspace_folder, before->outputs, threads)) return "its files were changed";
    return {};
}

std::vector<ContentEntry> outputs_in(const fs::path& product,
                                     const std::vector<ContentEntry>& outputs) {
    const std::string prefix = product.filename().string() + '/';
    std::vector<ContentEntry> inside;
    std::copy_if(outputs.begin(), outputs.end(), std::back_inserter(inside),
                 [&](const ContentEntry& output) { return output.name.starts_with(prefix); });
    return inside;
}

std::set<std::string> names_of(const std::vector<ContentEntry>& outputs) {
    std::set<std::string> names;
    for (const ContentEntry& output : outputs) names.insert(output.name);
    return names;
}

/// True where nothing lies in the product but what a run wrote, whether or not that was harmed.
bool holds_nothing_but(const std::vector<ContentEntry>& outputs, const fs::path& product) {
    const std::set<std::string> names = names_of(outputs);
    std::error_code status;
    fs::recursive_directory_iterator entry(product, status);
    for (; !status && entry != fs::recursive_directory_iterator(); entry.increment(status)) {
        if (entry->symlink_status().type() == fs::file_type::directory) continue;
        const fs::path name = entry->path().lexically_relative(product.parent_path());
        if (!names.contains(name.generic_string())) return false;
    }
    return !status;
}

/// The files of `folder`, named as they will be called below the workspace; where it is told, those
/// alone that are outputs.
void append_content(std::vector<ContentEntry>& outputs, const fs::path& folder,
                    const std::string& final_name,
                    const std::function<bool(const std::string&)>& is_output, int threads) {
    for (ContentEntry& entry : content_of(folder, threads)) {
        if (is_output && !is_output(entry.name)) continue;
        outputs.push_back({final_name + '/' + entry.name, std::move(entry.sha256)});
    }
}

/// What was put beside the outputs of an earlier run. Hidden files are no outputs, and not kept.
void keep_files_of_others(WholeFolder& folder, const DoneMarker& before) {
    const std::set<std::string> outputs = names_of(before.outputs);
    folder.keep_files_of_others([&](const std::string& name) {
        const bool is_hidden = name.starts_with('.') || name.find("/.") != std::string::npos;
        return is_hidden || name == kDoneMarkerName ||
               outputs.contains(before.identity.stage + '/' + name);
    });
}

FinishedStage run_stage(const Workspace& workspace, const Stage& stage,
                        const std::optional<DoneMarker>& before, int threads) {
    const std::string& name = stage.identity.stage;
    const Stopwatch stopwatch;
    WholeFolder folder(workspace.stage_folder(name));

    DoneMarker marker;
    marker.identity = stage.identity;
    marker.evidence = stage.run(folder.staging());
    append_content(marker.outputs, folder.staging(), name, {}, threads);
    if (!stage.product.empty()) {
        append_content(marker.outputs, stage.product, stage.product.filename().string(),
                       stage.is_of_product, threads);
    }
    marker.cost = stopwatch.elapsed();
    // Hidden, and so no output: it outlives the marker, which is removed to run a stage again.
    mark_as_made_by_lumi(folder.staging());
    write_done_marker(folder.staging() / kDoneMarkerName, marker);
    if (before) keep_files_of_others(folder, *before);
    folder.put_in_place();
    return {name, true, {}, marker.cost, marker.evidence, std::move(marker.outputs)};
}

/// What a stage warned of when it ran holds while its result does.
void note_warnings(const StageEvidence& evidence, Progress& progress) {
    const auto facts = nlohmann::ordered_json::parse(evidence.facts_json);
    if (!facts.contains("warnings")) return;
    for (const auto& warning : facts.at("warnings")) {
        if (warning.is_string()) progress.note(warning.get<std::string>());
    }
}

}  // namespace

FinishedStage bring_up_to_date(const Workspace& workspace, const Stage& stage, int threads,
                               Progress& progress, StageStore* store) {
    const std::string& name = stage.identity.stage;
    std::optional<DoneMarker> before =
        read_done_marker(workspace.stage_folder(name) / kDoneMarkerName);
    std::string reason = reason_to_run(stage.identity, before, workspace.folder(), threads);
    if (reason.empty()) {
        progress.note(name + ": up to date");
        note_warnings(before->evidence, progress);
        return {name, false, {}, before->cost, before->evidence, std::move(before->outputs)};
    }
    progress.throw_if_interrupted();
    const bool is_shared = store != nullptr && stage.product.empty();
    if (is_shared) {
        if (auto kept = store->fetch(stage.identity, workspace, threads)) {
            progress.note(name + ": taken from the store");
            note_warnings(kept->evidence, progress);
            return {name, false, {}, kept->cost, kept->evidence, std::move(kept->outputs)};
        }
        if (const auto failure = store->failure_of(stage.identity)) throw Error(*failure);
    }
    progress.note(name + ": runs (" + reason + ")");
    // What stands there is ours, as the marker says, but no longer what its writer would replace.
    if (before && !stage.product.empty()) {
        const std::vector<ContentEntry> outputs = outputs_in(stage.product, before->outputs);
        if (holds_nothing_but(outputs, stage.product) &&
            !are_unharmed(workspace.folder(), outputs, threads))
            fs::remove_all(stage.product);
    }
    FinishedStage finished;
    try {
        finished = run_stage(workspace, stage, before, threads);
    } catch (const Error& failure) {
        if (is_shared) store->keep_failure(stage.identity, failure);
        throw;
    }
    finished.reason = std::move(reason);
    if (is_shared) store->keep(stage.identity, workspace);
    return finished;
}

}  // namespace lumi
