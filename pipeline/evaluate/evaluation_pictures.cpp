#include "pipeline/evaluate/evaluation_pictures.h"

#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "pipeline/evaluate/comparison_strip.h"
#include "pipeline/evaluate/heat_map.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/text/hyphenated.h"
#include "render/paths/photograph_eye.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

std::string strip_name(const std::string& stem, const std::string& method) {
    return stem + '.' + hyphenated(method) + ".png";
}

/// The modes and methods whose strips bear their names.
std::vector<std::string> named_methods(const Json& evaluation) {
    std::vector<std::string> methods;
    const auto add_keys = [&](const Json& named) {
        if (!named.is_object()) return;
        for (const auto& [name, scores] : named.items()) methods.push_back(name);
    };
    add_keys(evaluation.value("modes", Json()));
    const Json rivals = evaluation.value("rivals", Json());
    if (rivals.is_object()) add_keys(rivals.value("methods", Json()));
    return methods;
}

}  // namespace

EvaluationPictures::EvaluationPictures(const Capture& capture,
                                       const std::vector<Photograph>& photographs,
                                       RenderMode first_mode)
    : first_mode_(first_mode) {
    const std::vector<std::string> names = view_names(capture);
    const std::vector<std::string> stems = file_stems_without_dots(names);
    for (std::size_t i = 0; i < names.size(); ++i) stem_of_[names[i]] = stems[i];
    for (const Photograph& photograph : photographs)
        exif_orientation_of_[photograph.name] = photograph.exif_orientation;
}

void EvaluationPictures::write(const std::filesystem::path& folder, RenderMode mode,
                               const JudgedView& view) const {
    const std::string& name = view.score.name;
    write_strip(folder / strip(name, mode), view);
    if (mode != first_mode_) return;
    const int orientation = exif_orientation_of_.at(name);
    write_png(folder / map(name, "flip"),
              turned_upright(heat_map(view.flip, kFlipFullScale), orientation));
    if (!view.ghost_energy.empty()) {
        write_png(
            folder / map(name, "ghost"),
            turned_upright(heat_map(square_root(view.ghost_energy), kGhostFullScale), orientation));
    }
}

void EvaluationPictures::write(const std::filesystem::path& folder, const std::string& method,
                               const JudgedView& view) const {
    write_strip(folder / strip(view.score.name, method), view);
}

std::string EvaluationPictures::strip(const std::string& view, RenderMode mode) const {
    return mode == first_mode_ ? stem_of_.at(view) + ".png" : strip(view, name_of(mode));
}

std::string EvaluationPictures::strip(const std::string& view, const std::string& method) const {
    return strip_name(stem_of_.at(view), method);
}

std::string EvaluationPictures::map(const std::string& view, const std::string& kind) const {
    return stem_of_.at(view) + '.' + kind + ".png";
}

void EvaluationPictures::write_strip(const std::filesystem::path& path,
                                     const JudgedView& view) const {
    const int orientation = exif_orientation_of_.at(view.score.name);
    write_png(path, comparison_strip(turned_upright(view.photograph, orientation),
                                     turned_upright(view.rendering.color, orientation),
                                     turned_upright(view.rendering.coverage, orientation)));
}

std::set<std::string> names_of_pictures(const Json& evaluation) {
    std::set<std::string> names;
    if (!evaluation.is_object()) return names;
    const std::vector<std::string> methods = named_methods(evaluation);
    for (const Json& view : evaluation.value("views", Json::array())) {
        for (const char* key : {"picture", "flip_picture", "ghost_picture"}) {
            const auto name = view.find(key);
            if (name != view.end() && name->is_string()) names.insert(name->get<std::string>());
        }
        const auto first = view.find("picture");
        if (first == view.end() || !first->is_string()) continue;
        const std::string stem = std::filesystem::path(first->get<std::string>()).stem().string();
        for (const std::string& method : methods) names.insert(strip_name(stem, method));
    }
    return names;
}

}  // namespace lumi
