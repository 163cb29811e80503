#include "pipeline/evaluate/stale_package.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/workspace/done_marker.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/stage_outputs.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What a finished stage wrote below a folder of the workspace, nothing where that was harmed; all
/// that lies there where no marker tells.
std::vector<ContentEntry> outputs_in(const WorkspaceLayout& workspace, const std::string& folder,
                                     int threads) {
    const std::string prefix = folder + '/';
    const std::string stage = folder.substr(0, folder.find('/'));
    std::vector<ContentEntry> outputs;
    if (const auto marker = read_done_marker(workspace.stage_folder(stage) / kDoneMarkerName)) {
        for (const ContentEntry& output : marker->outputs) {
            if (output.name.starts_with(prefix)) outputs.push_back(output);
        }
        return are_unharmed(workspace.folder(), outputs, threads) ? outputs
                                                                  : std::vector<ContentEntry>();
    }
    for (ContentEntry& entry : content_of(workspace.folder() / folder, threads)) {
        if (entry.name != kDoneMarkerName)
            outputs.push_back({prefix + entry.name, std::move(entry.sha256)});
    }
    return outputs;
}

/// What lies in these folders, as a record tells it. Whatever else somebody put there counts no
/// more than it does to the stages.
std::string sha256_of_folders(const WorkspaceLayout& workspace,
                              const std::vector<std::string>& folders, int threads) {
    std::vector<ContentEntry> all;
    for (const std::string& folder : folders) {
        const std::vector<ContentEntry> outputs = outputs_in(workspace, folder, threads);
        all.insert(all.end(), outputs.begin(), outputs.end());
    }
    return sha256_of_content(all);
}

/// What the last run of the line tells, which may have ended before it came to the package.
std::string why_last_run_left_it(const WorkspaceLayout& workspace, const PackRecord& record) {
    std::error_code status;
    if (!fs::is_regular_file(workspace.stages_path(), status)) return {};
    const Json run = read_json_file(workspace.stages_path());
    try {
        if (run.contains("failure")) {
            const Json& failure = run.at("failure");
            return "the package is of a run before the last one, which ended in the stage " +
                   failure.at("stage").get<std::string>() + " (" +
                   failure.at("code").get<std::string>() + ")";
        }
        const Json& stages = run.at("stages");
        const bool came_to_it = std::any_of(stages.begin(), stages.end(), [](const Json& stage) {
            return stage.at("name") == "pack";
        });
        const std::string configuration = run.value("configuration_sha256", "");
        const bool says_nothing = configuration.empty() || record.configuration_sha256.empty();
        if (came_to_it || says_nothing || configuration == record.configuration_sha256) return {};
    } catch (const Json::exception& error) {
        refuse_json(workspace.stages_path(), error);
    }
    return "the package is of an earlier configuration";
}

}  // namespace

std::string why_package_is_stale(const WorkspaceLayout& workspace, const PackRecord& record,
                                 int threads) {
    if (package_sha256(workspace) != record.package_sha256)
        return "the package is not the one that was recorded, as by a run that did not end";
    // Working copies, too: they bear numbers, which move where a photograph goes or comes.
    const auto differs = [&](const std::string& recorded, const std::vector<std::string>& folders) {
        return !recorded.empty() && sha256_of_folders(workspace, folders, threads) != recorded;
    };
    if (differs(record.pictures_sha256, {"ingest", "poses/pinhole"}))
        return "the package was made from other photographs or poses";
    if (differs(record.mesh_sha256, {"mesh"}) || differs(record.depth_sha256, {"depth"}))
        return "the package is of an earlier configuration: the camera mesh or the depth beside "
               "it is another";
    return why_last_run_left_it(workspace, record);
}

}  // namespace lumi
