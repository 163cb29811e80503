#include "calib/known_poses/transforms_json.h"

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "calib/known_poses/camera_axes.h"
#include "calib/work/error.h"
#include "calib/work/json_fault.h"
#include "calib/work/whole_file.h"

namespace lumi {
namespace {

using Json = nlohmann::json;

[[noreturn]] void refuse_json(const std::string& where_and_what) {
    throw Error(ErrorKind::kBadInput, "E-IMPORT-JSON", where_and_what,
                "write transforms.json again with the program it comes from");
}

[[noreturn]] void refuse_json(const std::string& where, const std::string& what) {
    refuse_json(where + ": " + what);
}

[[noreturn]] void refuse_lens(const std::string& where, const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-IMPORT-LENS", where + ": " + what,
                "undistort the photographs first, or let lumi estimate the poses");
}

Json parse(const std::filesystem::path& path) {
    constexpr int kMaxDepth = 32;
    constexpr std::size_t kMaxBytes = std::size_t{256} << 20;
    const auto bounded = [&](int depth, Json::parse_event_t, Json&) {
        if (depth > kMaxDepth) refuse_json(path.string(), "nested deeper than 32 levels");
        return true;
    };
    try {
        return Json::parse(read_whole_text(path, kMaxBytes), bounded);
    } catch (const Json::exception& exception) {
        refuse_json(json_fault(path.string(), exception));
    }
}

double finite_number(const Json& value, const std::string& where) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
        refuse_json(where, "expected a finite number");
    }
    return value.get<double>();
}

/// What a frame says of its lens, or else what the file says of all.
class LensFields {
 public:
    LensFields(const Json& frame, const Json& file, std::string where)
        : frame_(frame), file_(file), where_(std::move(where)) {}

    [[nodiscard]] const Json* find(const char* key) const {
        for (const Json* object : {&frame_, &file_}) {
            const auto value = object->find(key);
            if (value != object->end() && !value->is_null()) return &*value;
        }
        return nullptr;
    }
    [[nodiscard]] std::optional<double> number(const char* key) const {
        const Json* value = find(key);
        if (value == nullptr) return std::nullopt;
        return finite_number(*value, where_ + "." + key);
    }
    [[nodiscard]] int side(const char* key) const {
        constexpr double kMaxSide = 1 << 20;
        const double value = number(key).value_or(0);
        if (value < 0 || value > kMaxSide || value != std::floor(value)) {
            refuse_json(where_ + "." + key, "expected a picture size");
        }
        return static_cast<int>(value);
    }
    [[nodiscard]] const std::string& where() const { return where_; }

 private:
    const Json& frame_;
    const Json& file_;
    std::string where_;
};

bool is_fisheye(const LensFields& fields) {
    const Json* flag = fields.find("is_fisheye");
    if (flag != nullptr && flag->is_boolean() && flag->get<bool>()) return true;
    const Json* model = fields.find("camera_model");
    if (model == nullptr) return false;
    if (!model->is_string()) refuse_json(fields.where() + ".camera_model", "expected a text");
    const auto& name = model->get_ref<const std::string&>();
    if (name == "OPENCV_FISHEYE") return true;
    constexpr std::array<const char*, 5> kPerspective{"PINHOLE", "SIMPLE_PINHOLE", "OPENCV",
                                                      "SIMPLE_RADIAL", "RADIAL"};
    if (std::find(kPerspective.begin(), kPerspective.end(), name) == kPerspective.end()) {
        refuse_lens(fields.where(), "camera model '" + name + "' is not known to lumi");
    }
    return false;
}

std::array<double, 5> distortion_of(const LensFields& fields, bool is_fisheye) {
    const auto of = [&](const char* key) { return fields.number(key).value_or(0.0); };
    if (is_fisheye) {
        if (of("p1") != 0 || of("p2") != 0) {
            refuse_lens(fields.where(), "a fisheye lens with p1 or p2 is not known to lumi");
        }
        return {of("k1"), of("k2"), of("k3"), of("k4")};
    }
    if (of("k4") != 0) refuse_lens(fields.where(), "a lens with k4 is not known to lumi");
    return {of("k1"), of("k2"), of("p1"), of("p2"), of("k3")};
}

std::optional<double> angle_of_view(const LensFields& fields, const char* key) {
    const auto angle_rad = fields.number(key);
    if (angle_rad && (!(*angle_rad > 0) || !(*angle_rad < 3.14))) {
        refuse_json(fields.where() + "." + key, "expected an angle of view");
    }
    return angle_rad;
}

KnownLens lens_of(const LensFields& fields) {
    const int width_px = fields.side("w");
    const int height_px = fields.side("h");
    if ((width_px > 0) != (height_px > 0)) {
        refuse_json(fields.where(), "expected both w and h, or neither");
    }
    StatedLens lens;
    lens.focal_x_px = fields.number("fl_x");
    lens.focal_y_px = fields.number("fl_y");
    if (!lens.focal_x_px) lens.angle_of_view_x_rad = angle_of_view(fields, "camera_angle_x");
    if (!lens.focal_y_px) lens.angle_of_view_y_rad = angle_of_view(fields, "camera_angle_y");
    lens.centre_x_px = fields.number("cx");
    lens.centre_y_px = fields.number("cy");
    lens.is_fisheye = is_fisheye(fields);
    lens.distortion = distortion_of(fields, lens.is_fisheye);
    const bool is_in_pixels = lens.focal_x_px || lens.focal_y_px;
    if (!is_in_pixels && !lens.angle_of_view_x_rad && !lens.angle_of_view_y_rad) {
        refuse_json(fields.where(), "no fl_x and no camera_angle_x");
    }
    if (width_px > 0) return {lens_for_size(lens, width_px, height_px), std::nullopt};
    if (is_in_pixels && (!lens.centre_x_px || !lens.centre_y_px)) {
        refuse_json(fields.where(), "neither w and h nor cx and cy");
    }
    return {{}, lens};
}

Rigid3 pose_of(const Json& frame, const std::string& where) {
    const auto matrix = frame.find("transform_matrix");
    if (matrix == frame.end() || !matrix->is_array() || matrix->size() < 3) {
        refuse_json(where + ".transform_matrix", "expected four rows of four numbers");
    }
    Eigen::Matrix<double, 3, 4> world_from_gl;
    for (std::size_t row = 0; row < 3; ++row) {
        const Json& numbers = (*matrix)[row];
        if (!numbers.is_array() || numbers.size() != 4) {
            refuse_json(where + ".transform_matrix", "expected four rows of four numbers");
        }
        for (std::size_t column = 0; column < 4; ++column) {
            world_from_gl(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
                finite_number(numbers[column], where + ".transform_matrix");
        }
    }
    // OpenGL's camera looks along -z and has +y up.
    const Eigen::Matrix3d world_from_cam =
        world_from_gl.leftCols<3>() * Eigen::Vector3d(1, -1, -1).asDiagonal();
    return pose_from_axes(world_from_cam, world_from_gl.col(3), where);
}

/// Whether a frame before says the same of this photograph. One that says something else is wrong.
bool is_repeated(const View& view, const std::map<std::string, View>& before,
                 const std::string& where) {
    const auto same_name = before.find(view.name);
    if (same_name == before.end()) return false;
    const View& other = same_name->second;
    const bool is_same =
        other.camera_index == view.camera_index &&
        other.cam_from_world.rotation.coeffs() == view.cam_from_world.rotation.coeffs() &&
        other.cam_from_world.translation == view.cam_from_world.translation;
    if (is_same) return true;
    refuse_json(where, "'" + view.name + "' has another pose or lens in a frame before");
}

}  // namespace

KnownPoses read_transforms_json(const std::filesystem::path& path) {
    const Json file = parse(path);
    const auto frames = file.is_object() ? file.find("frames") : file.end();
    if (!file.is_object() || frames == file.end() || !frames->is_array()) {
        refuse_json(path.string(), "expected a list of frames");
    }
    KnownPoses known;
    known.format = "transforms.json";
    std::map<std::string, View> by_name;
    for (std::size_t i = 0; i < frames->size(); ++i) {
        const Json& frame = (*frames)[i];
        const std::string where = path.string() + ": frames[" + std::to_string(i) + "]";
        if (!frame.is_object()) refuse_json(where, "expected an object");
        const auto name = frame.find("file_path");
        if (name == frame.end() || !name->is_string()) refuse_json(where, "expected a file_path");
        const KnownLens lens = lens_of(LensFields(frame, file, where));
        const View view{name->get<std::string>(), index_of_lens(known.lenses, lens),
                        pose_of(frame, where)};
        if (is_repeated(view, by_name, where)) continue;
        by_name.emplace(view.name, view);
        known.views.push_back(view);
    }
    return known;
}

}  // namespace lumi
