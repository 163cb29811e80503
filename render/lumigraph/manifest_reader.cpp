#include <algorithm>
#include <cmath>
#include <set>

#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/manifest_words.h"
#include "render/lumigraph/package_folder.h"
#include "render/lumigraph/strict_json.h"

namespace lumi {
namespace {

constexpr int kMaxSide_px = 1 << 16;
constexpr int kMaxTriangles = 1 << 28;

PackageFile file_of(const StrictJsonObject& object, std::string_view ending) {
    PackageFile file{object.text("path"), object.byte_count("bytes"), object.text("sha256")};
    if (!is_safe_package_path(file.path) || !file.path.ends_with(ending)) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-PATH",
                    std::string(kManifestName) + ": '" + printable(file.path) +
                        "': expected a plain lower-case path below the package that ends in " +
                        std::string(ending),
                    "do not trust this package: lumi never writes such a path");
    }
    const bool is_checksum = file.sha256.size() == kChecksumDigits &&
                             file.sha256.find_first_not_of("0123456789abcdef") == std::string::npos;
    if (!is_checksum) object.refuse("sha256", "64 lower-case hexadecimal digits");
    return file;
}

Camera camera_of(const StrictJsonObject& object) {
    const auto model = lens_model_named(object.text("model"));
    if (model != LensModel::kPinhole) object.refuse("model", "PINHOLE");
    Camera camera{object.integer("width_px", 1, kMaxSide_px),
                  object.integer("height_px", 1, kMaxSide_px), *model,
                  object.numbers("parameters", parameter_count(*model))};
    if (focal_length_px(camera).minCoeff() <= 0) object.refuse("parameters", "focal lengths > 0");
    return camera;
}

Rigid3 pose_of(const StrictJsonObject& object) {
    const std::vector<double> q = object.numbers("rotation_wxyz", 4);
    const std::vector<double> t = object.numbers("translation", 3);
    const Rigid3 pose{Eigen::Quaterniond(q[0], q[1], q[2], q[3]), {t[0], t[1], t[2]}};
    if (!is_rigid(pose)) {
        object.refuse("rotation_wxyz", "a quaternion of length 1");
    }
    return pose;
}

void expect_range(const StrictJsonObject& object, double min, double max) {
    // Kept as 32-bit floats: a finite double may still be too large.
    const bool in_range = min >= 0 && min <= max && std::isfinite(static_cast<float>(max));
    if (!in_range) object.refuse("max_inverse_depth", "0 <= min <= max within 32-bit floats");
}

ManifestDepthMesh depth_mesh_of(const StrictJsonObject& object, const ManifestDepth& depth) {
    ManifestDepthMesh mesh;
    CodedDepthMeshHeader& header = mesh.header;
    header.columns = object.integer("columns", 1, depth.width_px);
    header.rows = object.integer("rows", 1, depth.height_px);
    header.wanted_error_px = object.number("wanted_error_px");
    header.error_px = object.number("error_px");
    header.disparity_px = object.number("disparity_px");
    const bool is_stated =
        header.wanted_error_px > 0 && header.error_px > 0 && header.disparity_px > 0;
    if (!is_stated) object.refuse("error_px", "errors and disparity > 0");
    header.min_inverse_depth = object.number("min_inverse_depth");
    header.max_inverse_depth = object.number("max_inverse_depth");
    expect_range(object, header.min_inverse_depth, header.max_inverse_depth);
    header.vertices = object.integer("vertices", 0, kMaxTriangles);
    header.triangles = {object.integer("seen_triangles", 0, kMaxTriangles),
                        object.integer("filled_triangles", 0, kMaxTriangles),
                        object.integer("stretched_triangles", 0, kMaxTriangles)};
    mesh.code_bytes = object.byte_count("code_bytes");
    mesh.file = file_of(object.object("file"), ".mesh");
    return mesh;
}

ManifestDepth depth_of(const StrictJsonObject& object) {
    ManifestDepth depth{object.integer("width_px", 1, kMaxSide_px),
                        object.integer("height_px", 1, kMaxSide_px),
                        object.number("min_inverse_depth"),
                        object.number("max_inverse_depth"),
                        file_of(object.object("inverse_depth"), ".png"),
                        file_of(object.object("confidence"), ".png"),
                        std::nullopt};
    expect_range(object, depth.min_inverse_depth, depth.max_inverse_depth);
    if (object.has("mesh")) depth.mesh = depth_mesh_of(object.object("mesh"), depth);
    return depth;
}

ExposureGain exposure_gain_of(const StrictJsonObject& object) {
    const std::string key = "exposure_gain";
    const std::vector<double> numbers = object.numbers(key, 3);
    const bool in_range = std::all_of(numbers.begin(), numbers.end(), [](double gain) {
        return gain >= 1 / kLargestExposureGain && gain <= kLargestExposureGain;
    });
    if (!in_range) object.refuse(key, "factors from 1/16 to 16");
    return {numbers[0], numbers[1], numbers[2]};
}

ManifestView view_of(const StrictJsonObject& object) {
    ManifestView view;
    view.name = object.text("name");
    if (view.name.empty()) object.refuse("name", "a name");
    view.photograph = file_of(object.object("photograph"), ".png");
    view.exif_orientation = object.integer("exif_orientation", 1, 8);
    view.camera = camera_of(object.object("camera"));
    view.cam_from_world = pose_of(object.object("cam_from_world"));
    if (object.has("exposure_gain")) view.exposure_gain = exposure_gain_of(object);
    if (object.has("depth")) view.depth = depth_of(object.object("depth"));
    return view;
}

void check_header(const StrictJsonObject& document, std::string_view text,
                  const std::string& where) {
    if (document.text("format") != kPackageFormat) {
        document.refuse("format", "'" + std::string(kPackageFormat) + "'");
    }
    const int version = document.integer("schema_version", 0, 1 << 30);
    if (version != kPackageSchemaVersion) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-VERSION",
                    where + ": schema_version " + std::to_string(version) + ", expected " +
                        std::to_string(kPackageSchemaVersion),
                    "build the package again with this version of lumi");
    }
    if (with_manifest_checksum(std::string(text)) != text) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-CHECKSUM",
                    where + ": is not the manifest that was written: its checksum differs",
                    "the package is damaged: copy it again, or build it again with `lumi build`");
    }
    if (document.text("blending_space") != kBlendingSpace) {
        document.refuse("blending_space", "'" + std::string(kBlendingSpace) + "'");
    }
}

bool read(const StrictJsonObject& document, const DrawingChoice<bool>& choice) {
    return document.boolean(choice.name);
}

int read(const StrictJsonObject& document, const DrawingChoice<int>& choice) {
    return document.integer(choice.name, choice.least, choice.most);
}

double read(const StrictJsonObject& document, const DrawingChoice<double>& choice) {
    return document.number(choice.name, choice.least, choice.most);
}

/// What is not there is as usual.
DrawingChoices drawing_of(const StrictJsonObject& document) {
    DrawingChoices drawing;
    for_each_drawing_choice([&](const auto& choice) {
        if (document.has(choice.name)) drawing.*choice.member = read(document, choice);
    });
    return drawing;
}

void expect_unique_names(const std::vector<ManifestView>& views, const StrictJsonObject& document) {
    std::set<std::string> names;
    for (const ManifestView& view : views) {
        if (!names.insert(view.name).second) {
            document.refuse("views", "different names, found '" + view.name + "' twice");
        }
    }
}

}  // namespace

Manifest parse_manifest(std::string_view text, const PackageLimits& limits,
                        const std::string& where) {
    const auto document = StrictJsonObject::parse(text, limits.max_json_depth, where);
    check_header(document, text, where);
    Manifest manifest;
    manifest.name = document.text("name");
    manifest.near_depth = document.number("near_depth");
    manifest.far_depth = document.number("far_depth");
    if (manifest.near_depth < 0 || manifest.far_depth < manifest.near_depth) {
        document.refuse("far_depth", "0 <= near_depth <= far_depth");
    }
    if (document.has("noisy_depth_error_px"))
        manifest.noisy_depth_error_px = document.number(
            "noisy_depth_error_px", kLeastNoisyDepthError_px, kMostNoisyDepthError_px);
    manifest.drawing = drawing_of(document);
    if (document.has("light_falloff")) manifest.light_falloff = document.number("light_falloff");
    for (const StrictJsonObject& view : document.objects("views", limits.max_views)) {
        manifest.views.push_back(view_of(view));
    }
    expect_unique_names(manifest.views, document);
    manifest.camera_mesh = file_of(document.object("camera_mesh"), ".ply");
    manifest.points = file_of(document.object("points"), ".ply");
    manifest.config = file_of(document.object("config"), ".toml");
    manifest.evidence_json = document.object("evidence").json_text();
    return manifest;
}

Manifest read_manifest(const PackageFolder& package, const PackageLimits& limits) {
    const Bytes bytes = package.read_unchecked(kManifestName, limits.max_manifest_bytes);
    return parse_manifest({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, limits,
                          (package.folder() / kManifestName).string());
}

Manifest read_manifest(const std::filesystem::path& folder, const PackageLimits& limits) {
    return read_manifest(PackageFolder(folder), limits);
}

}  // namespace lumi
