#include "pipeline/report/workspace_report.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "calib/capture/image_io.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/report/html.h"
#include "pipeline/report/lens_tables.h"
#include "pipeline/report/number_text.h"
#include "pipeline/report/verdict.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using Rows = std::vector<std::vector<std::string>>;

constexpr int kStripWidthPx = 1400;
constexpr int kDepthWidthPx = 240;
constexpr std::size_t kMaxDepthPictures = 24;

/// The evidence of a stage; null when the stage is not there.
Json evidence_of(const Json& stages, const std::string& name, const char* part = "evidence") {
    for (const Json& stage : stages.at("stages")) {
        if (stage.at("name") == name) return stage.at(part);
    }
    return nullptr;
}

std::string text_of(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_number_float()) return number_text(value.get<double>(), 3);
    return value.dump();
}

/// "mean_reprojection_error_px" as words.
std::string words_of(std::string key) {
    std::replace(key.begin(), key.end(), '_', ' ');
    return key;
}

/// Names and plain values of an object, one a row; lists and objects stand elsewhere.
std::string table_of_values(const Json& object) {
    Rows rows;
    for (const auto& [key, value] : object.items()) {
        if (!value.is_structured()) rows.push_back({words_of(key), text_of(value)});
    }
    return html_table({"what", "value"}, rows);
}

std::string verdict_section(const Verdict& verdict) {
    const char* style = verdict.level == Verdict::Level::kGood   ? "good"
                        : verdict.level == Verdict::Level::kFair ? "fair"
                                                                 : "bad";
    std::string html = std::string("<div class=\"verdict ") + style + "\"><strong>" +
                       html_escaped(verdict.headline) + "</strong>";
    for (const std::string& remark : verdict.remarks) {
        html += "<br>" + html_escaped(remark);
    }
    return html + "</div>\n";
}

void append_left_out(Rows& rows, const Json& left_out) {
    for (const Json& entry : left_out) {
        rows.push_back(
            {text_of(entry.at("name")), text_of(entry.at("code")), text_of(entry.at("reason"))});
    }
}

bool is_listed(const Json& left_out, const std::string& name) {
    return std::any_of(left_out.begin(), left_out.end(),
                       [&](const Json& entry) { return entry.at("name") == name; });
}

/// Every photograph that was read, and what became of it.
std::string used_photographs(const WorkspaceLayout& workspace, const Json& stages) {
    const Json poses = evidence_of(stages, "poses");
    const Json pack = evidence_of(stages, "pack");
    Rows rows;
    for (const Photograph& photograph :
         read_photograph_list(workspace.stage_folder("ingest")).photographs) {
        std::string use = "read";
        if (!poses.is_null()) {
            use = is_listed(poses.at("not_registered"), photograph.name) ? "no pose" : "used";
        }
        if (!pack.is_null() && use == "used") {
            const auto held_out = pack.at("held_out").get<std::vector<std::string>>();
            const bool is_held_out =
                std::binary_search(held_out.begin(), held_out.end(), photograph.name);
            if (is_held_out) use = "held out";
        }
        rows.push_back(
            {photograph.name,
             std::to_string(photograph.width_px) + " x " + std::to_string(photograph.height_px),
             use});
    }
    return html_details("Every photograph",
                        html_table({"photograph", "size in pixels", "use"}, rows));
}

std::string photographs_section(const WorkspaceLayout& workspace, const Json& stages) {
    const Json ingest = evidence_of(stages, "ingest");
    if (ingest.is_null()) return {};
    const Json poses = evidence_of(stages, "poses");
    std::string html = "<p>" + text_of(ingest.at("photographs")) + " photographs were read";
    if (!poses.is_null()) {
        html += ", " + text_of(poses.at("photographs_registered")) + " of them found their place";
    }
    html += ".</p>\n";
    Rows rows;
    append_left_out(rows, ingest.at("left_out"));
    if (!poses.is_null()) append_left_out(rows, poses.at("not_registered"));
    if (!rows.empty()) html += html_table({"left out", "code", "why"}, rows);
    return html_section("Photographs", html + used_photographs(workspace, stages));
}

std::string poses_section(const Json& stages) {
    const Json poses = evidence_of(stages, "poses");
    if (poses.is_null()) return {};
    std::string html = table_of_values(poses);
    for (const Json& lens : poses.at("lenses")) html += lens_table(lens);
    html += pose_uncertainty_table(poses);
    const Json timings = evidence_of(stages, "poses", "timings");
    std::string calls;
    for (const Json& call : timings.value("colmap_calls", Json::array())) {
        calls += number_text(call.at("wall_s").get<double>(), 1) + " s  " +
                 text_of(call.at("command_line")) + "\n";
    }
    if (!calls.empty()) {
        html += html_details("COLMAP, as it was called", "<pre>" + html_escaped(calls) + "</pre>");
    }
    return html_section("Poses", html);
}

std::string mesh_section(const WorkspaceLayout& workspace, const Json& stages) {
    Json mesh = evidence_of(stages, "mesh");
    if (mesh.is_null()) return {};
    std::string html = "<p>" + html_escaped(text_of(mesh.at("explanation"))) + "</p>\n";
    mesh.erase("explanation");
    const fs::path svg_path = workspace.stage_folder("mesh") / "camera_mesh.svg";
    std::error_code status;
    if (fs::is_regular_file(svg_path, status)) {
        html += html_svg_figure(read_whole_text(svg_path), "The camera mesh");
    }
    return html_section("Camera mesh", html + table_of_values(mesh));
}

/// At most `count` of the paths, spread evenly.
std::vector<fs::path> spread(const std::vector<fs::path>& paths, std::size_t count) {
    if (paths.size() <= count) return paths;
    std::vector<fs::path> chosen;
    for (std::size_t i = 0; i < count; ++i) chosen.push_back(paths[i * paths.size() / count]);
    return chosen;
}

std::string depth_section(const WorkspaceLayout& workspace, const Json& stages) {
    const Json depth = evidence_of(stages, "depth");
    if (depth.is_null()) return {};
    static const std::string kEnding = ".inverse_depth.png";
    std::vector<fs::path> pictures;
    for (const auto& entry : fs::directory_iterator(workspace.stage_folder("depth"))) {
        if (entry.path().string().ends_with(kEnding)) pictures.push_back(entry.path());
    }
    std::sort(pictures.begin(), pictures.end());
    std::string html = "<p>Inverse depth: near is bright, far is dark.</p><div class=\"grid\">\n";
    for (const fs::path& path : spread(pictures, kMaxDepthPictures)) {
        const std::string file = path.filename().string();
        html += html_figure(read_color_image(path), kDepthWidthPx,
                            file.substr(0, file.size() - kEnding.size()));
    }
    html += "</div>\n";
    Rows rows;
    for (const Json& view : depth.at("views")) {
        rows.push_back({text_of(view.at("name")), text_of(view.at("model")),
                        number_text(100.0 * view.at("confident_share").get<double>(), 1),
                        text_of(view.at("sparse_residual_px"))});
    }
    html += html_details("Every view", html_table({"view", "model", "agreed on by other views (%)",
                                                   "distance to sparse points (px)"},
                                                  rows));
    return html_section("Depth", html);
}

std::vector<std::string> score_row(const std::string& name, const Json& score) {
    const Json& covered = score.at("psnr_covered_db");
    return {name,
            number_text(score.at("psnr_db").get<double>(), 2),
            covered.is_null() ? "none covered" : number_text(covered.get<double>(), 2),
            number_text(score.at("ssim").get<double>(), 4),
            number_text(100.0 * score.at("coverage").get<double>(), 2),
            number_text(score.at("ms").get<double>(), 1)};
}

std::string scores_table(const std::string& mode, const Json& scores) {
    Rows rows{score_row("mean", scores.at("mean"))};
    for (const Json& view : scores.at("views")) {
        rows.push_back(score_row(text_of(view.at("name")), view));
    }
    return "<h3>" + html_escaped(mode) + "</h3>" +
           html_table({"view", "PSNR (dB)", "PSNR, covered (dB)", "SSIM", "covered (%)", "ms"},
                      rows);
}

std::string evaluation_section(const WorkspaceLayout& workspace, const Json& evaluation) {
    if (evaluation.is_null()) return {};
    std::string html = scores_table(text_of(evaluation.at("mode")), evaluation);
    for (const auto& [mode, scores] : evaluation.at("modes").items()) {
        html += scores_table(mode, scores);
    }
    html +=
        "<p>Photograph, rendering and error: dark blue is none, bright yellow is 64 of 255 and "
        "more; hatched was not drawn. Drawn with " +
        html_escaped(text_of(evaluation.at("gl"))) + ".</p>\n";
    for (const Json& view : evaluation.at("views")) {
        const fs::path picture = workspace.evaluation_folder() / text_of(view.at("picture"));
        html += html_figure(read_color_image(picture), kStripWidthPx,
                            text_of(view.at("name")) + ": " +
                                number_text(view.at("psnr_db").get<double>(), 2) + " dB");
    }
    return html_section("Held-out photographs", html);
}

std::string seconds_section(const Json& stages) {
    Rows rows;
    for (const Json& stage : stages.at("stages")) {
        rows.push_back({text_of(stage.at("name")), text_of(stage.at("state")),
                        number_text(stage.at("wall_s").get<double>(), 2),
                        number_text(stage.at("cpu_s").get<double>(), 2),
                        number_text(stage.at("peak_mib").get<double>(), 0)});
    }
    return html_section("Seconds",
                        html_table({"stage", "state", "seconds", "CPU seconds", "peak MiB"}, rows));
}

}  // namespace

void write_workspace_report(const WorkspaceLayout& workspace) {
    const Json stages = read_json_file(workspace.stages_path());
    const Json evaluation = read_current_evaluation(workspace);
    std::string body = verdict_section(verdict_of(stages, evaluation));
    body += evaluation_section(workspace, evaluation);
    body += photographs_section(workspace, stages);
    body += poses_section(stages);
    body += mesh_section(workspace, stages);
    body += depth_section(workspace, stages);
    body += seconds_section(stages);
    body += html_section(
        "Configuration",
        html_details("Every setting, with defaults filled in",
                     "<pre>" + html_escaped(read_whole_text(workspace.config_path())) + "</pre>"));
    write_whole_text(workspace.report_path(), html_page("lumi: " + workspace.name(), body));
}

}  // namespace lumi
