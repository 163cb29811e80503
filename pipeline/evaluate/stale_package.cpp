#include "pipeline/evaluate/stale_package.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/workspace/content.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/stage_outputs.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// What lies in these folders now, as a record tells it.
std::string sha256_of_folders(const WorkspaceLayout& workspace,
                              const std::vector<std::string>& folders, int threads) {
    std::vector<ContentEntry> all;
    for (const std::string& folder : folders) {
        for (ContentEntry& entry : content_of(workspace.folder() / folder, threads)) {
            if (entry.name != kDoneMarkerName)
                all.push_back({folder + '/' + entry.name, std::move(entry.sha256)});
        }
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
