#include "pipeline/evaluate/evaluate_workspace.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "calib/ingest/made_by_lumi.h"
#include "calib/pictures/image_io.h"
#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/whole_folder.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/evaluate/evaluation_pictures.h"
#include "pipeline/evaluate/filled_alike.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/evaluate/held_out_subject.h"
#include "pipeline/stages/photograph_list.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/json_file.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_without_pose(const PackRecord& record, const Capture& posed) {
    std::vector<std::string> with_pose = view_names(posed);
    std::sort(with_pose.begin(), with_pose.end());
    std::vector<std::string> without;
    std::set_difference(record.held_out.begin(), record.held_out.end(), with_pose.begin(),
                        with_pose.end(), std::back_inserter(without));
    return without;
}

std::string sha256_of_pixels(const fs::path& picture) {
    const ColorImage image = read_color_image(picture);
    static_assert(sizeof(Rgb8) == 3);
    return sha256_hex({reinterpret_cast<const std::uint8_t*>(image.pixels().data()),
                       image.pixels().size() * sizeof(Rgb8)});
}

/// Notes with each view which photograph it was compared with, by its working copy: what was
/// compared with is that copy as a lens straightens it, which is found anew where poses are.
void name_photographs(const std::vector<Photograph>& photographs, Evaluation& evaluation) {
    std::map<std::string, std::string> sha256_of;
    for (const ViewScore& view : evaluation.modes.front().views) sha256_of[view.name] = "";
    for (const Photograph& photograph : photographs) {
        const auto wanted = sha256_of.find(photograph.name);
        if (wanted != sha256_of.end()) wanted->second = sha256_of_pixels(photograph.picture_path);
    }
    const auto note = [&](std::vector<ViewScore>& views) {
        for (ViewScore& view : views) view.photograph_sha256 = sha256_of[view.name];
    };
    for (ModeScores& mode : evaluation.modes) note(mode.views);
    if (!evaluation.rivals) return;
    for (RivalScores& rival : evaluation.rivals->methods) note(rival.views);
}

/// Where each view's pictures lie, in evaluation.json.
void name_pictures(nlohmann::ordered_json& views, const EvaluationPictures& pictures,
                   RenderMode mode) {
    for (auto& view : views) {
        const auto name = view["name"].get<std::string>();
        view["picture"] = pictures.strip(name, mode);
        view["flip_picture"] = pictures.map(name, "flip");
        if (!view["ghost_energy"].is_null()) view["ghost_picture"] = pictures.map(name, "ghost");
    }
}

/// What evaluations before made stays no longer than they.
void keep_files_of_others(WholeFolder& folder, const fs::path& evaluation_folder) {
    std::set<std::string> ours;
    const fs::path record = evaluation_folder / kEvaluationName;
    std::error_code status;
    if (fs::is_regular_file(record, status)) {
        try {
            ours = names_of_pictures(read_json_file(record));
        } catch (const Error&) {
            ours.clear();  // Damaged: nothing tells whose a picture is.
        }
    }
    folder.keep_files_of_others([&](const std::string& name) { return ours.contains(name); });
}

}  // namespace

Evaluation evaluate_workspace(const Workspace& workspace, const EvaluationOptions& options,
                              const std::string& code_version, int threads, Progress& progress) {
    const PackRecord record = finished_pack(workspace);
    const PosedPhotographs held_out = held_out_photographs(workspace, record, threads);
    const Lumigraph lumigraph = read_package(workspace.package_folder(), {}, options.exposures);
    const std::vector<Photograph> photographs =
        read_photograph_list(workspace.stage_folder("ingest")).photographs;
    const EvaluationPictures pictures(held_out.capture, photographs, options.modes.front());
    const EvaluationOptions with_subject = judging_subject(options, workspace);

    WholeFolder folder(workspace.evaluation_folder());
    std::optional<FilledAlike> compared;  // Of every mode and method.
    if (options.rivals) compared.emplace(lumigraph, held_out);
    Evaluation evaluation = evaluate_held_out(
        lumigraph, held_out, with_subject,
        [&](RenderMode mode, const JudgedView& view) {
            pictures.write(folder.staging(), mode, view);
            if (!compared) return;
            const RenderMode drawn = possible_options({.mode = mode}, lumigraph.has_depth()).mode;
            compared->add({name_of(mode), covers_by_depth(drawn)}, view);
        },
        progress);
    if (options.rivals) {
        evaluation.rivals = evaluate_rivals(
            lumigraph, held_out, with_subject.subject_mask, options.timed_frames,
            [&](const ComparedMethod& method, const JudgedView& view) {
                pictures.write(folder.staging(), method.name, view);
                compared->add(method, view);
            },
            progress);
        evaluation.rivals->common = compared->scores_of(evaluation);
    }

    evaluation.not_judged = names_without_pose(record, held_out.capture);
    name_photographs(photographs, evaluation);

    nlohmann::ordered_json json = evaluation_json(evaluation);
    json["package_sha256"] = package_sha256(workspace);
    json["pictures_sha256"] = record.pictures_sha256;
    json["depth_sha256"] = record.depth_sha256;
    json["made_with"] = made_with_json(options, code_version);
    name_pictures(json["views"], pictures, options.modes.front());
    // The workspace may lie among the photographs, and strips are none.
    mark_as_made_by_lumi(folder.staging());
    write_json_file(folder.staging() / kEvaluationName, json);
    keep_files_of_others(folder, workspace.evaluation_folder());
    folder.put_in_place();
    return evaluation;
}

}  // namespace lumi
