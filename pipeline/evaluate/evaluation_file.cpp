#include "pipeline/evaluate/evaluation_file.h"

#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json score_json(const ViewScore& score) {
    return Json{{"psnr_db", score.psnr_db},
                {"psnr_covered_db", score.psnr_covered_db ? Json(*score.psnr_covered_db) : Json()},
                {"ssim", score.ssim},
                {"coverage", score.coverage},
                {"ms", score.ms}};
}

Json mode_json(const ModeScores& scores) {
    Json views = Json::array();
    for (const ViewScore& view : scores.views) {
        Json entry{{"name", view.name}};
        entry.update(score_json(view));
        views.push_back(std::move(entry));
    }
    return Json{{"mean", score_json(mean_score(scores.views))}, {"views", std::move(views)}};
}

}  // namespace

Json evaluation_json(const Evaluation& evaluation) {
    Json json{{"schema_version", 1},
              {"mode", name_of(evaluation.modes.front().mode)},
              {"gl", evaluation.gl_description}};
    json.update(mode_json(evaluation.modes.front()));
    Json others = Json::object();
    for (std::size_t i = 1; i < evaluation.modes.size(); ++i) {
        others[name_of(evaluation.modes[i].mode)] = mode_json(evaluation.modes[i]);
    }
    json["modes"] = std::move(others);
    return json;
}

std::string package_sha256(const WorkspaceLayout& workspace) {
    return sha256_hex_of_file(workspace.package_folder() / "lumigraph.json");
}

Json read_current_evaluation(const WorkspaceLayout& workspace) {
    const std::filesystem::path path = workspace.evaluation_folder() / "evaluation.json";
    std::error_code status;
    if (!std::filesystem::is_regular_file(path, status) ||
        !std::filesystem::is_directory(workspace.package_folder(), status)) {
        return nullptr;
    }
    Json evaluation = read_json_file(path);
    if (evaluation.value("package_sha256", "") != package_sha256(workspace)) return nullptr;
    return evaluation;
}

}  // namespace lumi
