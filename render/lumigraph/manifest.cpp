#include "render/lumigraph/manifest.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "calib/work/error.h"

namespace lumi {
namespace {

using nlohmann::json;

constexpr const char* kFormat = "lumi package";
constexpr const char* kBlendingSpace = "sRGB, encoded values";
constexpr double kUnitTolerance = 1e-6;

[[noreturn]] void refuse(const std::string& what) {
    throw Error(ErrorKind::kBadInput, "E-PACKAGE-MANIFEST", "lumigraph.json: " + what,
                "the package is damaged; copy or build it again");
}

json json_of(const PackageFile& file) {
    return {{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}};
}

json json_of(const ManifestView& view) {
    const Eigen::Quaterniond& rotation = view.cam_from_world.rotation;
    const Eigen::Vector3d& translation = view.cam_from_world.translation;
    json result = {{"name", view.name},
                   {"photograph", json_of(view.photograph)},
                   {"exif_orientation", view.exif_orientation},
                   {"camera",
                    {{"model", name_of(view.camera.model)},
                     {"width_px", view.camera.width_px},
                     {"height_px", view.camera.height_px},
                     {"parameters", view.camera.parameters}}},
                   {"cam_from_world",
                    {{"rotation_wxyz", {rotation.w(), rotation.x(), rotation.y(), rotation.z()}},
                     {"translation", {translation.x(), translation.y(), translation.z()}}}}};
    if (view.has_depth) {
        result["depth"] = {{"inverse_depth", json_of(view.inverse_depth)},
                           {"confidence", json_of(view.confidence)},
                           {"width_px", view.depth_width_px},
                           {"height_px", view.depth_height_px},
                           {"min_inverse_depth", view.min_inverse_depth},
                           {"max_inverse_depth", view.max_inverse_depth}};
    }
    return result;
}

/// Stops at a depth that no manifest needs; the library itself overflows the stack at 1e5.
json parse_bounded(std::string_view text, int max_depth) {
    const auto bounded = [max_depth](int depth, json::parse_event_t, json&) {
        if (depth > max_depth) refuse("is nested too deeply");
        return true;
    };
    try {
        return json::parse(text, bounded);
    } catch (const json::exception& exception) {
        refuse(exception.what());
    }
}

const json& field(const json& object, const char* key) {
    if (!object.is_object() || !object.contains(key)) {
        refuse(std::string("expected a field '") + key + "'");
    }
    return object.at(key);
}

double finite(const json& value, const char* key) {
    if (!value.is_number() || !std::isfinite(value.get<double>())) {
        refuse(std::string("expected a finite number for '") + key + "'");
    }
    return value.get<double>();
}

int whole(const json& object, const char* key, int min, int max) {
    const json& value = field(object, key);
    if (!value.is_number_integer() || value.get<std::int64_t>() < min ||
        value.get<std::int64_t>() > max) {
        refuse(std::string("expected '") + key + "' between " + std::to_string(min) + " and " +
               std::to_string(max));
    }
    return value.get<int>();
}

std::string text_of(const json& object, const char* key) {
    const json& value = field(object, key);
    if (!value.is_string()) refuse(std::string("expected a text for '") + key + "'");
    return value.get<std::string>();
}

template <std::size_t kCount>
std::array<double, kCount> numbers(const json& object, const char* key) {
    const json& value = field(object, key);
    if (!value.is_array() || value.size() != kCount) {
        refuse(std::string("expected ") + std::to_string(kCount) + " numbers for '" + key + "'");
    }
    std::array<double, kCount> result{};
    for (std::size_t i = 0; i < kCount; ++i) result[i] = finite(value[i], key);
    return result;
}

PackageFile file_of(const json& object, const char* key) {
    const json& value = field(object, key);
    PackageFile file;
    file.path = text_of(value, "path");
    file.sha256 = text_of(value, "sha256");
    const json& bytes = field(value, "bytes");
    if (!bytes.is_number_unsigned()) refuse("expected a size in bytes for " + file.path);
    file.bytes = bytes.get<std::uint64_t>();
    if (!is_safe_package_path(file.path)) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-PATH",
                    "lumigraph.json: '" + file.path + "' is not a plain path below the package",
                    "do not open this package: it was made to reach outside itself");
    }
    return file;
}

constexpr int kMaxSide = 1 << 16;

Camera camera_of(const json& object) {
    Camera camera;
    const auto model = lens_model_named(text_of(object, "model"));
    if (model != LensModel::kPinhole) refuse("expected a PINHOLE camera");
    camera.model = *model;
    camera.width_px = whole(object, "width_px", 1, kMaxSide);
    camera.height_px = whole(object, "height_px", 1, kMaxSide);
    const auto parameters = numbers<4>(object, "parameters");
    camera.parameters.assign(parameters.begin(), parameters.end());
    validate(camera, "lumigraph.json");
    return camera;
}

Rigid3 pose_of(const json& object) {
    const auto q = numbers<4>(object, "rotation_wxyz");
    const auto t = numbers<3>(object, "translation");
    const Rigid3 pose{Eigen::Quaterniond(q[0], q[1], q[2], q[3]), {t[0], t[1], t[2]}};
    if (std::abs(pose.rotation.norm() - 1) > kUnitTolerance) refuse("a rotation is not a rotation");
    return pose;
}

void read_depth(const json& object, ManifestView& view) {
    view.has_depth = true;
    view.inverse_depth = file_of(object, "inverse_depth");
    view.confidence = file_of(object, "confidence");
    view.depth_width_px = whole(object, "width_px", 1, kMaxSide);
    view.depth_height_px = whole(object, "height_px", 1, kMaxSide);
    view.min_inverse_depth = finite(field(object, "min_inverse_depth"), "min_inverse_depth");
    view.max_inverse_depth = finite(field(object, "max_inverse_depth"), "max_inverse_depth");
    if (view.min_inverse_depth < 0 || view.max_inverse_depth < view.min_inverse_depth) {
        refuse(view.name + ": its range of inverse depths is empty or negative");
    }
}

ManifestView view_of(const json& object) {
    ManifestView view;
    view.name = text_of(object, "name");
    if (view.name.empty()) refuse("a view has no name");
    view.photograph = file_of(object, "photograph");
    view.exif_orientation = whole(object, "exif_orientation", 1, 8);
    view.camera = camera_of(field(object, "camera"));
    view.cam_from_world = pose_of(field(object, "cam_from_world"));
    if (object.contains("depth")) read_depth(object.at("depth"), view);
    return view;
}

void check_header(const json& document) {
    if (text_of(document, "format") != kFormat)
        refuse("expected the format '" + std::string(kFormat) + "'");
    const json& version = field(document, "version");
    if (version != kPackageVersion) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-VERSION",
                    "lumigraph.json: version " + version.dump() + ", expected " +
                        std::to_string(kPackageVersion),
                    "build the package again with this version of lumi");
    }
    if (text_of(document, "blending") != kBlendingSpace) refuse("unknown blending space");
}

}  // namespace

bool is_safe_package_path(std::string_view path) {
    constexpr std::size_t kMaxLength = 200;
    if (path.empty() || path.size() > kMaxLength || path.back() == '/') return false;
    char previous = '/';
    for (const char c : path) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                           (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.' || c == '/';
        if (!plain || (previous == '/' && (c == '/' || c == '.'))) return false;
        previous = c;
    }
    return path.ends_with(".png") || path.ends_with(".ply") || path.ends_with(".toml");
}

std::string manifest_text(const Manifest& manifest) {
    json views = json::array();
    for (const ManifestView& view : manifest.views) views.push_back(json_of(view));
    const json document = {{"format", kFormat},
                           {"version", kPackageVersion},
                           {"blending", kBlendingSpace},
                           {"name", manifest.name},
                           {"near_depth", manifest.near_depth},
                           {"far_depth", manifest.far_depth},
                           {"views", views},
                           {"camera_mesh", json_of(manifest.camera_mesh)},
                           {"points", json_of(manifest.points)},
                           {"config", json_of(manifest.config)},
                           {"evidence", json::parse(manifest.evidence_json)}};
    return document.dump(1) + "\n";
}

Manifest parse_manifest(std::string_view text, int max_json_depth, std::size_t max_views) {
    const json document = parse_bounded(text, max_json_depth);
    check_header(document);
    Manifest manifest;
    manifest.name = text_of(document, "name");
    manifest.near_depth = finite(field(document, "near_depth"), "near_depth");
    manifest.far_depth = finite(field(document, "far_depth"), "far_depth");
    const json& views = field(document, "views");
    if (!views.is_array() || views.empty() || views.size() > max_views) {
        refuse("expected between 1 and " + std::to_string(max_views) + " views");
    }
    std::set<std::string> names;
    for (const json& view : views) {
        manifest.views.push_back(view_of(view));
        if (!names.insert(manifest.views.back().name).second) {
            refuse("two views are named " + manifest.views.back().name);
        }
    }
    manifest.camera_mesh = file_of(document, "camera_mesh");
    manifest.points = file_of(document, "points");
    manifest.config = file_of(document, "config");
    manifest.evidence_json = field(document, "evidence").dump();
    return manifest;
}

}  // namespace lumi
