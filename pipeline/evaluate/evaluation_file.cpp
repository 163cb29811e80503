#include "pipeline/evaluate/evaluation_file.h"

#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "pipeline/stages/pack_stage.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/optional_json.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json view_json(const ViewScore& score) {
    Json json{{"name", score.name},
              {"place", score.place == ViewPlace::kInterior ? "interior" : "border"}};
    for (const ScoreMetric& metric : score_metrics())
        json[metric.name] = optional_json(metric.value(score));
    json["ms_range"] = {score.fastest_ms, score.slowest_ms};
    json["gain"] = score.gain;
    json["subject_share"] = optional_json(score.subject_share);
    json["width_px"] = score.width_px > 0 ? Json(score.width_px) : Json();
    json["height_px"] = score.height_px > 0 ? Json(score.height_px) : Json();
    json["photograph_sha256"] =
        score.photograph_sha256.empty() ? Json() : Json(score.photograph_sha256);
    return json;
}

Json mean_json(const std::vector<ViewScore>& views) {
    Json json = Json::object();
    for (const ScoreMetric& metric : score_metrics()) {
        json[metric.name] = optional_json(mean_of(metric, views));
    }
    return json;
}

Json interval_json(const std::vector<ViewScore>& views) {
    Json json = Json::object();
    for (const ScoreMetric& metric : score_metrics()) {
        const auto interval = interval_of(metric, views);
        json[metric.name] = interval ? Json{interval->low, interval->high} : Json();
    }
    return json;
}

Json group_json(const std::vector<ViewScore>& views) {
    return Json{
        {"views", views.size()}, {"mean", mean_json(views)}, {"interval", interval_json(views)}};
}

/// What is said of any way of drawing.
Json scores_json(const std::vector<ViewScore>& all) {
    Json views = Json::array();
    for (const ViewScore& view : all) views.push_back(view_json(view));
    return Json{{"mean", mean_json(all)},
                {"interval", interval_json(all)},
                {"interior", group_json(views_at(ViewPlace::kInterior, all))},
                {"border", group_json(views_at(ViewPlace::kBorder, all))},
                {"views", std::move(views)}};
}

Json common_pixels_json(const CommonPixelScores& scores) {
    Json psnr_db = Json::object();
    for (const CommonPixelScores::Method& method : scores.methods)
        psnr_db[method.name] = optional_json(method.psnr_db);
    return Json{{"share", scores.share}, {"psnr_db", std::move(psnr_db)}};
}

Json rivals_json(const RivalEvaluation& rivals) {
    Json methods = Json::object();
    for (const RivalScores& scores : rivals.methods) {
        methods[scores.method] = {{"resampling_cpu_s", scores.resampling_cpu_s}};
        methods[scores.method].update(scores_json(scores.views));
    }
    Json left_out = Json::object();
    for (const RivalLeftOut& rival : rivals.left_out) left_out[rival.method] = rival.reason;
    Json json{{"methods", std::move(methods)}, {"left_out", std::move(left_out)}};
    if (rivals.common) json["common_pixels"] = common_pixels_json(*rivals.common);
    return json;
}

/// False for what is no object, too.
bool says(const Json& evaluation, const char* key, const Json& value) {
    const auto found = evaluation.find(key);
    return found != evaluation.end() && *found == value;
}

void expect_known_version(const Json& evaluation, const fs::path& path) {
    if (says(evaluation, "schema_version", kEvaluationSchemaVersion)) return;
    throw Error(ErrorKind::kBadInput, "E-EVAL-SCHEMA",
                path.string() + ": no evaluation of schema version " +
                    std::to_string(kEvaluationSchemaVersion),
                "run `lumi evaluate` again with this version of lumi");
}

/// And of the photographs and the depth, which tells subjects, that it was compared with.
bool is_of_package(const Json& evaluation, const WorkspaceLayout& workspace) {
    std::error_code status;
    if (!fs::is_directory(workspace.package_folder(), status)) return false;
    if (!fs::exists(workspace.stage_folder("pack"), status)) return false;
    const PackRecord record = read_pack_record(workspace.stage_folder("pack"));
    return says(evaluation, "package_sha256", package_sha256(workspace)) &&
           says(evaluation, "pictures_sha256", record.pictures_sha256) &&
           says(evaluation, "depth_sha256", record.depth_sha256);
}

Json evaluation_of_workspace(const WorkspaceLayout& workspace) {
    const fs::path path = workspace.evaluation_folder() / kEvaluationName;
    std::error_code status;
    if (!fs::exists(path, status)) {
        throw Error(ErrorKind::kBadInput, "E-EVAL-NONE",
                    workspace.folder().string() + ": its package was not evaluated",
                    "run `lumi evaluate " + workspace.folder().string() + "` first");
    }
    Json evaluation = read_json_file(path);
    expect_known_version(evaluation, path);
    if (is_of_package(evaluation, workspace)) return evaluation;
    throw Error(ErrorKind::kBadInput, "E-EVAL-STALE",
                path.string() +
                    ": not of the package, photographs and depth that stand there now, or "
                    "written by a version before",
                "run `lumi evaluate " + workspace.folder().string() + "` again");
}

/// Null when it is of another version, or not of what stands in the workspace.
Json evaluation_if_current(const fs::path& path, const WorkspaceLayout& workspace) {
    Json evaluation = read_json_file(path);
    const bool is_current = says(evaluation, "schema_version", kEvaluationSchemaVersion) &&
                            is_of_package(evaluation, workspace);
    return is_current ? evaluation : Json();
}

/// What an early version did not write down stays as it is.
template <class Value>
void read_where_it_is(const Json& json, const char* key, Value& value) {
    const auto found = json.find(key);
    if (found != json.end() && !found->is_null()) value = found->get<Value>();
}

ViewScore view_score_from(const Json& json) {
    ViewScore score;
    score.name = json.at("name");
    score.place = json.at("place") == "interior" ? ViewPlace::kInterior : ViewPlace::kBorder;
    for (const ScoreMetric& metric : score_metrics()) {
        const Json& value = json.at(metric.name);
        metric.set(score, metric.may_lack ? optional_number(value) : value.get<double>());
    }
    score.fastest_ms = json.at("ms_range").at(0);
    score.slowest_ms = json.at("ms_range").at(1);
    score.gain = json.at("gain");
    score.subject_share = optional_number(json.at("subject_share"));
    read_where_it_is(json, "width_px", score.width_px);
    read_where_it_is(json, "height_px", score.height_px);
    read_where_it_is(json, "photograph_sha256", score.photograph_sha256);
    return score;
}

}  // namespace

ModeScores mode_scores_from(RenderMode mode, const Json& json) {
    ModeScores scores{mode, {}, {}, {}};
    for (const Json& view : json.at("views")) scores.views.push_back(view_score_from(view));
    const Json& ghost = json.at("ghost_rank_correlation");
    scores.ghost_between_blocks = optional_number(ghost.at("between_blocks"));
    scores.ghost_between_views = optional_number(ghost.at("between_views"));
    return scores;
}

Json mode_scores_json(const ModeScores& scores) {
    Json json = scores_json(scores.views);
    json["ghost_rank_correlation"] = {
        {"between_blocks", optional_json(scores.ghost_between_blocks)},
        {"between_views", optional_json(scores.ghost_between_views)}};
    return json;
}

Json evaluation_json(const Evaluation& evaluation) {
    const BootstrapOptions bootstrap;
    Json json{
        {"schema_version", kEvaluationSchemaVersion},
        {"mode", name_of(evaluation.modes.front().mode)},
        {"gl", evaluation.gl_description},
        {"subject_from", evaluation.subject_from.empty() ? Json() : Json(evaluation.subject_from)},
        {"not_judged", evaluation.not_judged},
        {"bootstrap",
         {{"level", bootstrap.level},
          {"resamples", bootstrap.resamples},
          {"seed", bootstrap.seed}}}};
    json.update(mode_scores_json(evaluation.modes.front()));
    Json others = Json::object();
    for (std::size_t i = 1; i < evaluation.modes.size(); ++i) {
        others[name_of(evaluation.modes[i].mode)] = mode_scores_json(evaluation.modes[i]);
    }
    json["modes"] = std::move(others);
    json["rivals"] = evaluation.rivals ? rivals_json(*evaluation.rivals) : Json();
    return json;
}

std::string name_of(Exposures exposures) {
    return exposures == Exposures::kEvened ? "evened" : "as taken";
}

Json made_with_json(const EvaluationOptions& options, const std::string& code_version) {
    Json modes = Json::array();
    for (const RenderMode mode : options.modes) modes.push_back(name_of(mode));
    return Json{{"modes", std::move(modes)},
                {"exposures", name_of(options.exposures)},
                {"ghost_energy", options.ghost_energy},
                {"rivals", options.rivals},
                {"code", code_version}};
}

std::string package_sha256(const WorkspaceLayout& workspace) {
    return sha256_hex_of_file(workspace.package_folder() / kManifestName);
}

Json read_evaluation(const fs::path& file_or_folder) {
    std::error_code status;
    if (fs::is_directory(file_or_folder, status))
        return evaluation_of_workspace(find_workspace(file_or_folder));
    Json evaluation = read_json_file(file_or_folder);
    expect_known_version(evaluation, file_or_folder);
    return evaluation;
}

Json read_current_evaluation(const WorkspaceLayout& workspace) {
    const fs::path path = workspace.evaluation_folder() / kEvaluationName;
    std::error_code status;
    if (!fs::is_regular_file(path, status)) return nullptr;
    try {
        return evaluation_if_current(path, workspace);
    } catch (const Error&) {
        return nullptr;  // It or the record of the package is damaged.
    }
}

}  // namespace lumi
