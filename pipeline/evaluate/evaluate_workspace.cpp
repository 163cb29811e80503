#include "pipeline/evaluate/evaluate_workspace.h"

#include <map>
#include <nlohmann/json.hpp>

#include "calib/capture/image_io.h"
#include "calib/work/whole_folder.h"
#include "pipeline/evaluate/comparison_strip.h"
#include "pipeline/evaluate/evaluation_file.h"
#include "pipeline/evaluate/held_out_photographs.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/json_file.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// NAME.png for the mode that stands first, NAME.MODE.png for the others.
std::string strip_name(const std::string& stem, RenderMode mode, RenderMode first_mode) {
    return mode == first_mode ? stem + ".png" : stem + '.' + name_of(mode) + ".png";
}

}  // namespace

Evaluation evaluate_workspace(const Workspace& workspace, const std::vector<RenderMode>& modes,
                              int threads, Progress& progress) {
    const PackRecord record = finished_pack(workspace);
    const PosedPhotographs held_out = held_out_photographs(workspace, record, threads);
    const Lumigraph lumigraph = read_package(workspace.package_folder());

    const std::vector<std::string> names = view_names(held_out.capture);
    const std::vector<std::string> stems = file_stems_of_views(names);
    std::map<std::string, std::string> stem_of;
    for (std::size_t i = 0; i < names.size(); ++i) stem_of[names[i]] = stems[i];

    WholeFolder folder(workspace.evaluation_folder());
    const auto write_strip = [&](RenderMode mode, const JudgedView& view) {
        const std::string& stem = stem_of.at(view.score.name);
        write_png(folder.staging() / strip_name(stem, mode, modes.front()),
                  comparison_strip(view.photograph, view.rendering.color, view.rendering.coverage));
    };
    Evaluation evaluation = evaluate_held_out(lumigraph, held_out, modes, write_strip, progress);

    nlohmann::ordered_json json = evaluation_json(evaluation);
    json["package_sha256"] = package_sha256(workspace);
    for (auto& view : json["views"]) {
        view["picture"] = stem_of.at(view["name"].get<std::string>()) + ".png";
    }
    write_json_file(folder.staging() / "evaluation.json", json);
    folder.put_in_place();
    return evaluation;
}

}  // namespace lumi
