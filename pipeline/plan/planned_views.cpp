#include "pipeline/plan/planned_views.h"

#include <nlohmann/json.hpp>

#include "pipeline/text/number_text.h"
#include "pipeline/workspace/json_file.h"
#include "pipeline/workspace/workspace.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Rigid3 pose_of(const Json& suggestion) {
    const auto q = suggestion.at("rotation_wxyz").get<std::vector<double>>();
    const auto t = suggestion.at("translation").get<std::vector<double>>();
    return {Eigen::Quaterniond(q.at(0), q.at(1), q.at(2), q.at(3)).normalized(),
            {t.at(0), t.at(1), t.at(2)}};
}

std::string words_of(const Json& suggestion) {
    std::string words = number_text(suggestion.at("predicted_error_px").get<double>(), 2) +
                        " px here, " +
                        number_text(suggestion.at("worst_error_after_px").get<double>(), 2) +
                        " px at worst with a photograph";
    for (const Json& from : suggestion.at("from")) {
        words += "; from where " + from.at("name").get<std::string>() + " was taken " +
                 from.at("steps").get<std::string>();
    }
    return words;
}

}  // namespace

std::vector<PlannedView> planned_views_beside(const std::filesystem::path& package_folder) {
    const std::filesystem::path file = folder_around(package_folder) / "plan" / kPlanName;
    std::error_code status;
    if (!std::filesystem::is_regular_file(file, status)) return {};
    std::vector<PlannedView> planned;
    const Json plan = read_json_file(file);
    try {
        for (const Json& suggestion : plan.at("suggestions")) {
            planned.push_back({pose_of(suggestion), words_of(suggestion)});
            if (!planned.back().cam_from_world.translation.allFinite() ||
                !planned.back().cam_from_world.rotation.coeffs().allFinite()) {
                refuse_json(file, "a suggested pose is not finite");
            }
        }
    } catch (const Json::exception& error) {
        refuse_json(file, error);
    } catch (const std::out_of_range&) {
        refuse_json(file, "a suggested pose is incomplete");
    }
    return planned;
}

}  // namespace lumi
