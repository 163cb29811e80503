#include "pipeline/commands/eye_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "calib/work/error.h"
#include "calib/work/json_fault.h"
#include "calib/work/printable.h"
#include "pipeline/workspace/json_file.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kLongestPath_s = 24 * 3600;

/// A value of a file, and what to say of where it stands.
struct Found {
    const Json& json;
    std::string file;
    std::string place;  ///< As "eyes[3].camera"; empty: the whole.

    [[nodiscard]] Found at(const std::string& key) const {
        return {json.at(key), file, place.empty() ? key : place + "." + key};
    }
    [[nodiscard]] std::string where() const { return place.empty() ? file : file + ": " + place; }
};

/// People write such files, too.
[[noreturn]] void refuse_eye(const std::string& what_and_where) {
    throw Error(ErrorKind::kBadInput, "E-JSON-READ", what_and_where,
                "correct it (`lumi render --help` shows an eye, at --eye), or let the window write "
                "it");
}

[[noreturn]] void refuse_value(const Found& found, const std::string& reason) {
    refuse_eye(found.where() + ": " + reason);
}

/// As many as there have to be; `expected` says what they are.
template <std::size_t kCount>
std::array<double, kCount> numbers(const Found& found, const char* expected) {
    const auto values = found.json.get<std::vector<double>>();
    if (values.size() != kCount) refuse_value(found, std::string("expected ") + expected);
    std::array<double, kCount> counted{};
    std::copy(values.begin(), values.end(), counted.begin());
    return counted;
}

int whole_number(const Found& found) {
    const auto value = found.json.get<double>();
    if (value != std::trunc(value) || std::abs(value) > std::numeric_limits<int>::max())
        refuse_value(found, "expected a whole number");
    return static_cast<int>(value);
}

Rigid3 pose_from(const Found& found) {
    const auto wxyz = numbers<4>(found.at("rotation_wxyz"), "[w, x, y, z]");
    const auto xyz = numbers<3>(found.at("translation"), "[x, y, z]");
    const Eigen::Quaterniond rotation(wxyz[0], wxyz[1], wxyz[2], wxyz[3]);
    if (!(std::abs(rotation.norm() - 1.0) < 1e-3)) {
        refuse_value(found.at("rotation_wxyz"), "expected a quaternion of length one");
    }
    // What lumi wrote comes back to the bit.
    const bool is_exact = std::abs(rotation.norm() - 1.0) < 1e-12;
    return {is_exact ? rotation : rotation.normalized(), {xyz[0], xyz[1], xyz[2]}};
}

Camera camera_from(const Found& found) {
    Camera camera;
    if (found.json.at("model") != name_of(LensModel::kPinhole)) {
        refuse_value(found.at("model"), "expected PINHOLE, as an eye has no distortion");
    }
    camera.width_px = whole_number(found.at("width_px"));
    camera.height_px = whole_number(found.at("height_px"));
    camera.parameters = found.json.at("parameters").get<std::vector<double>>();
    if (camera.parameters.size() != parameter_count(LensModel::kPinhole)) {
        refuse_value(found.at("parameters"), "expected [fx, fy, cx, cy]");
    }
    validate(camera, found.where());
    return camera;
}

/// What the JSON library throws is said with the place.
template <class Read>
auto read_at(const Found& found, Read read) {
    try {
        return read(found);
    } catch (const Json::exception& error) {
        refuse_eye(json_fault(found.where(), error));
    }
}

Eye eye_from(const Found& found) {
    return read_at(found, [](const Found& eye) {
        return Eye{read_at(eye.at("camera"), camera_from),
                   read_at(eye.at("cam_from_world"), pose_from)};
    });
}

double seconds_from(const Found& found) { return found.json.get<double>(); }

/// Empty where the file does not say; `named` gives what a name stands for, if anything.
template <class Value>
std::optional<Value> named_value(const Found& found, const char* key,
                                 std::optional<Value> (*named)(const std::string&)) {
    if (!found.json.contains(key)) return std::nullopt;
    const auto name = found.json.at(key).get<std::string>();
    const std::optional<Value> value = named(name);
    if (!value) refuse_value(found.at(key), "there is none named " + name);
    return value;
}

std::optional<bool> boolean_value(const Json& json, const char* key) {
    if (!json.contains(key)) return std::nullopt;
    return json.at(key).get<bool>();
}

DrawnAlike drawn_from(const Found& found) {
    return {.mode = named_value(found, "mode", render_mode_named),
            .debug_picture = named_value(found, "debug_picture", debug_picture_named),
            .correct_occlusion = boolean_value(found.json, "correct_occlusion"),
            .fade_beyond_capture = boolean_value(found.json, "fade_beyond_capture"),
            .guess_surroundings = boolean_value(found.json, "guess_surroundings"),
            .as_taken = boolean_value(found.json, "as_taken")};
}

/// A time that is misspelt would be none. What screenshots say besides may stand in a path.
void check_keys(const Found& eye) {
    static const std::set<std::string> kKnown{"time_s",
                                              "camera",
                                              "cam_from_world",
                                              "lumigraph",
                                              "mode",
                                              "debug_picture",
                                              "as_taken",
                                              "correct_occlusion",
                                              "fade_beyond_capture",
                                              "guess_surroundings"};
    if (!eye.json.is_object()) return;
    for (const auto& [key, value] : eye.json.items())
        if (!kKnown.contains(key)) refuse_value(eye, "unknown key `" + printable(key) + "`");
}

/// The last eye follows those before it.
void check_next(const std::vector<TimedEye>& eyes, const Found& eye) {
    const TimedEye& last = eyes.back();
    if (last.eye.camera.width_px != eyes.front().eye.camera.width_px ||
        last.eye.camera.height_px != eyes.front().eye.camera.height_px)
        refuse_value(eye, "all must have the size of the first");
    const double before_s = eyes.size() > 1 ? eyes[eyes.size() - 2].time_s : 0.0;
    if (!(last.time_s >= before_s && last.time_s <= kLongestPath_s))
        refuse_value(eye.at("time_s"), "expected seconds that do not fall, from 0 to a day");
}

std::vector<TimedEye> path_from(const Found& found, double eyes_per_second_without_times) {
    const Found eyes = found.at("eyes");
    if (!eyes.json.is_array() || eyes.json.empty())
        refuse_value(eyes, "expected a list of eyes, one at least");
    const bool has_times = eyes.json.front().contains("time_s");
    std::vector<TimedEye> timed;
    for (const Json& json_eye : eyes.json) {
        const Found eye{json_eye, found.file, "eyes[" + std::to_string(timed.size()) + "]"};
        check_keys(eye);
        if (json_eye.contains("time_s") != has_times)
            refuse_value(eye, "time_s: all eyes must have one, or none");
        const double index = static_cast<double>(timed.size());
        timed.push_back({has_times ? read_at(eye.at("time_s"), seconds_from)
                                   : index / eyes_per_second_without_times,
                         eye_from(eye)});
        check_next(timed, eye);
    }
    // It begins with its first eye, whenever that was.
    const double began_s = timed.front().time_s;
    for (TimedEye& eye : timed) eye.time_s -= began_s;
    return timed;
}

/// An eye and a path are told apart before anything is found missing in them.
void check_kind(const Json& json, const char* expected, const char* other, const std::string& what,
                const std::string& advice, const std::filesystem::path& path) {
    if (json.contains(expected) || !json.contains(other)) return;
    throw Error(ErrorKind::kBadInput, "E-JSON-READ", path.string() + ": " + what, advice);
}

EyeFile eye_file_from(const Json& json, const std::filesystem::path& path) {
    check_kind(json, "cam_from_world", "eyes", "is a path of eyes, and not one of them",
               "`--path` takes it", path);
    return read_at(Found{json, path.string(), {}}, [](const Found& found) {
        return EyeFile{eye_from(found), drawn_from(found)};
    });
}

std::vector<TimedEye> path_file_from(const Json& json, const std::filesystem::path& path,
                                     double eyes_per_second_without_times) {
    check_kind(json, "eyes", "cam_from_world", "is a screenshot's eye, and no path",
               "`--eye` takes it", path);
    return read_at(Found{json, path.string(), {}}, [&](const Found& found) {
        return path_from(found, eyes_per_second_without_times);
    });
}

}  // namespace

EyeFile read_eye_file(const std::filesystem::path& path) {
    return eye_file_from(read_json_file(path), path);
}

std::vector<TimedEye> read_path_file(const std::filesystem::path& path,
                                     double eyes_per_second_without_times) {
    return path_file_from(read_json_file(path), path, eyes_per_second_without_times);
}

std::vector<TimedEye> read_eyes_of_window(const std::filesystem::path& path) {
    std::filesystem::path file = path;
    if (file.extension() == ".png") file.replace_extension(".json");
    std::error_code status;
    if (!std::filesystem::exists(file, status) && file != path)
        throw Error(ErrorKind::kBadInput, "E-JSON-READ",
                    path.string() + ": is no screenshot of a window: no " +
                        file.filename().string() + " lies beside it",
                    "name a package's folder, a screenshot, or a recorded path");
    const Json json = read_json_file(file);
    if (json.contains("eyes")) return path_file_from(json, file, kUsualEyesPerSecond);
    return {{0.0, eye_file_from(json, file).eye}};
}

}  // namespace lumi
