#include "pipeline/commands/eye_file.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Rigid3 pose_from(const Json& json, const std::filesystem::path& path) {
    const auto wxyz = json.at("rotation_wxyz").get<std::array<double, 4>>();
    const auto xyz = json.at("translation").get<std::array<double, 3>>();
    const Eigen::Quaterniond rotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    if (!(std::abs(rotation.norm() - 1.0) < 1e-3)) {
        refuse_json(path, "rotation_wxyz: expected a quaternion of length one");
    }
    return {rotation.normalized(), {xyz[0], xyz[1], xyz[2]}};
}

Camera camera_from(const Json& json, const std::filesystem::path& path) {
    Camera camera;
    if (json.at("model") != name_of(LensModel::kPinhole)) {
        refuse_json(path, "camera.model: expected PINHOLE, as an eye has no distortion");
    }
    camera.width_px = json.at("width_px");
    camera.height_px = json.at("height_px");
    camera.parameters = json.at("parameters").get<std::vector<double>>();
    if (camera.parameters.size() != parameter_count(LensModel::kPinhole)) {
        refuse_json(path, "camera.parameters: expected [fx, fy, cx, cy]");
    }
    validate(camera, path.string());
    return camera;
}

Eye eye_from(const Json& json, const std::filesystem::path& path) {
    return {camera_from(json.at("camera"), path), pose_from(json.at("cam_from_world"), path)};
}

}  // namespace

Eye read_eye_file(const std::filesystem::path& path) {
    const Json json = read_json_file(path);
    try {
        return eye_from(json, path);
    } catch (const Json::exception& error) {
        refuse_json(path, error.what());
    }
}

std::vector<Eye> read_path_file(const std::filesystem::path& path) {
    const Json json = read_json_file(path);
    try {
        std::vector<Eye> eyes;
        for (const Json& eye : json.at("eyes")) eyes.push_back(eye_from(eye, path));
        if (eyes.empty()) refuse_json(path, "eyes: a path needs one at least");
        for (const Eye& eye : eyes)
            if (eye.camera.width_px != eyes.front().camera.width_px ||
                eye.camera.height_px != eyes.front().camera.height_px)
                refuse_json(path, "eyes: all must have the size of the first");
        return eyes;
    } catch (const Json::exception& error) {
        refuse_json(path, error.what());
    }
}

}  // namespace lumi
