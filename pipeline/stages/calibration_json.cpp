#include "pipeline/stages/calibration_json.h"

#include <nlohmann/json.hpp>

#include "pipeline/stages/left_out_json.h"
#include "pipeline/stages/lens_choice_json.h"
#include "pipeline/workspace/optional_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json parameters_json(const std::vector<LensParameter>& parameters) {
    Json json = Json::array();
    for (const LensParameter& parameter : parameters) {
        json.push_back({{"name", parameter.name},
                        {"value", parameter.value},
                        {"sigma", parameter.sigma},
                        {"interval_95", {parameter.low, parameter.high}}});
    }
    return json;
}

Json bow_json(const std::optional<BoardBend>& bow) {
    if (!bow) return Json();
    return {{"per_pitch", bow->per_pitch},
            {"share_of_width", bow->share_of_width},
            {"sigma", bow->sigma_share},
            {"depth_pitches", bow->depth_pitches},
            {"width_pitches", bow->width_pitches}};
}

Json views_json(const std::vector<CalibratedView>& views) {
    Json json = Json::array();
    for (const CalibratedView& view : views) {
        json.push_back({{"photograph", view.photograph},
                        {"points", view.points},
                        {"rms_px", view.rms_px},
                        {"held_out_rms_px", optional_json(view.held_out_rms_px)},
                        {"tilt_deg", view.tilt_deg}});
    }
    return json;
}

}  // namespace

Json calibration_json(const BoardPhotographs& found, const BoardCalibration& calibration) {
    std::vector<LeftOut> left_out = found.left_out;
    left_out.insert(left_out.end(), calibration.left_out.begin(), calibration.left_out.end());
    return Json{{"board",
                 {{"kind", name_of(found.kind)},
                  {"columns", found.columns},
                  {"rows", found.rows},
                  {"size_per_pitch", calibration.size_per_pitch},
                  {"bow", bow_json(calibration.bow)}}},
                {"lens",
                 {{"model", name_of(calibration.lens.model)},
                  {"width_px", calibration.lens.width_px},
                  {"height_px", calibration.lens.height_px},
                  {"parameters", calibration.lens.parameters}}},
                {"form", text_of(calibration.form)},
                {"parameters", parameters_json(calibration.parameters)},
                {"not_kept", calibration.dropped},
                {"rms_px", calibration.rms_px},
                {"held_out_rms_px", optional_json(calibration.held_out_rms_px)},
                {"point_sigma_px", calibration.certainty.point_sigma_px},
                {"disagreement", calibration.certainty.disagreement},
                {"points", calibration.residuals.size()},
                {"removed_points", calibration.removed_points},
                {"covered_area", calibration.covered_area},
                {"covered_radius", calibration.covered_radius},
                {"models", lens_choice_json(calibration.choice)},
                {"photographs", views_json(calibration.views)},
                {"left_out", left_out_json(left_out)},
                {"warnings", calibration.warnings}};
}

}  // namespace lumi
