#include "pipeline/commands/eye_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "calib/work/error.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLongestPath_s = 24 * 3600;

/// As many as there have to be; `expected` says what they are.
template <std::size_t kCount>
std::array<double, kCount> numbers(const Json& json, const char* key, const char* expected,
                                   const std::filesystem::path& path) {
    const auto values = json.at(key).get<std::vector<double>>();
    if (values.size() != kCount) refuse_json(path, std::string(key) + ": expected " + expected);
    std::array<double, kCount> counted{};
    std::copy(values.begin(), values.end(), counted.begin());
    return counted;
}

int whole_number(const Json& json, const char* key, const std::filesystem::path& path) {
    const auto value = json.at(key).get<double>();
    if (value != std::trunc(value) || std::abs(value) > std::numeric_limits<int>::max())
        refuse_json(path, std::string(key) + ": expected a whole number");
    return static_cast<int>(value);
}

/// An eye and a path are told apart before anything is found missing in them.
void check_kind(const Json& json, const char* expected, const char* other, const std::string& what,
                const std::string& advice, const std::filesystem::path& path) {
    if (json.contains(expected) || !json.contains(other)) return;
    throw Error(ErrorKind::kBadInput, "E-JSON-READ", path.string() + ": " + what, advice);
}

Rigid3 pose_from(const Json& json, const std::filesystem::path& path) {
    const auto wxyz = numbers<4>(json, "rotation_wxyz", "[w, x, y, z]", path);
    const auto xyz = numbers<3>(json, "translation", "[x, y, z]", path);
    const Eigen::Quaterniond rotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    if (!(std::abs(rotation.norm() - 1.0) < 1e-3)) {
        refuse_json(path, "rotation_wxyz: expected a quaternion of length one");
    }
    // What lumi wrote comes back to the bit.
    const bool is_exact = std::abs(rotation.norm() - 1.0) < 1e-12;
    return {is_exact ? rotation : rotation.normalized(), {xyz[0], xyz[1], xyz[2]}};
}

Camera camera_from(const Json& json, const std::filesystem::path& path) {
    Camera camera;
    if (json.at("model") != name_of(LensModel::kPinhole)) {
        refuse_json(path, "camera.model: expected PINHOLE, as an eye has no distortion");
    }
    camera.width_px = whole_number(json, "width_px", path);
    camera.height_px = whole_number(json, "height_px", path);
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

/// Empty where the file does not say; `named` gives what a name stands for, if anything.
template <class Value>
std::optional<Value> named_value(const Json& json, const char* key,
                                 std::optional<Value> (*named)(const std::string&),
                                 const std::filesystem::path& path) {
    if (!json.contains(key)) return std::nullopt;
    const auto name = json.at(key).get<std::string>();
    const std::optional<Value> value = named(name);
    if (!value) refuse_json(path, std::string(key) + ": there is none named " + name);
    return value;
}

std::optional<bool> boolean_value(const Json& json, const char* key) {
    if (!json.contains(key)) return std::nullopt;
    return json.at(key).get<bool>();
}

DrawnAlike drawn_from(const Json& json, const std::filesystem::path& path) {
    return {.mode = named_value(json, "mode", render_mode_named, path),
            .debug_picture = named_value(json, "debug_picture", debug_picture_named, path),
            .correct_occlusion = boolean_value(json, "correct_occlusion"),
            .fade_beyond_capture = boolean_value(json, "fade_beyond_capture"),
            .guess_surroundings = boolean_value(json, "guess_surroundings"),
            .as_taken = boolean_value(json, "as_taken")};
}

/// The last eye follows those before it.
void check_next(const std::vector<TimedEye>& eyes, const std::filesystem::path& path) {
    const TimedEye& last = eyes.back();
    if (last.eye.camera.width_px != eyes.front().eye.camera.width_px ||
        last.eye.camera.height_px != eyes.front().eye.camera.height_px)
        refuse_json(path, "eyes: all must have the size of the first");
    const double before_s = eyes.size() > 1 ? eyes[eyes.size() - 2].time_s : 0.0;
    if (!(last.time_s >= before_s && last.time_s <= kLongestPath_s))
        refuse_json(path, "time_s: expected seconds that grow from 0, a day at most");
}

}  // namespace

EyeFile read_eye_file(const std::filesystem::path& path) {
    const Json json = read_json_file(path);
    check_kind(json, "cam_from_world", "eyes", "is a path of eyes, and not one of them",
               "`lumi render --path` draws it", path);
    try {
        return {eye_from(json, path), drawn_from(json, path)};
    } catch (const Json::exception& error) {
        refuse_json(path, error);
    }
}

std::vector<TimedEye> read_path_file(const std::filesystem::path& path,
                                     double eyes_per_second_without_times) {
    const Json json = read_json_file(path);
    check_kind(json, "eyes", "cam_from_world", "is a screenshot's eye, and no path",
               "`lumi render --eye` draws it", path);
    try {
        const Json& eyes = json.at("eyes");
        if (eyes.empty()) refuse_json(path, "eyes: a path needs one at least");
        const bool has_times = eyes.front().contains("time_s");
        std::vector<TimedEye> timed;
        for (const Json& eye : eyes) {
            if (eye.contains("time_s") != has_times)
                refuse_json(path, "time_s: all eyes must have one, or none");
            const double time_s =
                has_times ? eye.at("time_s").get<double>()
                          : static_cast<double>(timed.size()) / eyes_per_second_without_times;
            timed.push_back({time_s, eye_from(eye, path)});
            check_next(timed, path);
        }
        return timed;
    } catch (const Json::exception& error) {
        refuse_json(path, error);
    }
}

}  // namespace lumi
