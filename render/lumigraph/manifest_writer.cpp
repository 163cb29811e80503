#include <nlohmann/json.hpp>

#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/manifest_words.h"
#include "render/lumigraph/strict_json.h"

namespace lumi {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PackageFile& file) {
    return {{"path", file.path}, {"bytes", file.bytes}, {"sha256", file.sha256}};
}

Json json_of(const Camera& camera) {
    return {{"model", name_of(camera.model)},
            {"width_px", camera.width_px},
            {"height_px", camera.height_px},
            {"parameters", camera.parameters}};
}

Json json_of(const Rigid3& pose) {
    const Eigen::Quaterniond& q = pose.rotation;
    const Eigen::Vector3d& t = pose.translation;
    return {{"rotation_wxyz", {q.w(), q.x(), q.y(), q.z()}},
            {"translation", {t.x(), t.y(), t.z()}}};
}

Json json_of(const ManifestDepthMesh& mesh) {
    const CodedDepthMeshHeader& header = mesh.header;
    return {{"columns", header.columns},
            {"rows", header.rows},
            {"wanted_error_px", header.wanted_error_px},
            {"error_px", header.error_px},
            {"disparity_px", header.disparity_px},
            {"min_inverse_depth", header.min_inverse_depth},
            {"max_inverse_depth", header.max_inverse_depth},
            {"vertices", header.vertices},
            {"seen_triangles", header.triangles[0]},
            {"filled_triangles", header.triangles[1]},
            {"stretched_triangles", header.triangles[2]},
            {"code_bytes", mesh.code_bytes},
            {"file", json_of(mesh.file)}};
}

Json json_of(const ManifestDepth& depth) {
    Json result = {{"width_px", depth.width_px},
                   {"height_px", depth.height_px},
                   {"min_inverse_depth", depth.min_inverse_depth},
                   {"max_inverse_depth", depth.max_inverse_depth},
                   {"inverse_depth", json_of(depth.inverse_depth)},
                   {"confidence", json_of(depth.confidence)}};
    if (depth.mesh) result["mesh"] = json_of(*depth.mesh);
    return result;
}

Json json_of(const ManifestView& view) {
    Json result = {{"name", view.name},
                   {"photograph", json_of(view.photograph)},
                   {"exif_orientation", view.exif_orientation},
                   {"camera", json_of(view.camera)},
                   {"cam_from_world", json_of(view.cam_from_world)}};
    // What is as usual is left out: packages without it are read as before.
    if (view.exposure_gain != kNoExposureGain) result["exposure_gain"] = view.exposure_gain;
    if (view.depth) result["depth"] = json_of(*view.depth);
    return result;
}

Json evidence_of(const Manifest& manifest) {
    // The evidence stands one level below the document.
    const int max_depth = PackageLimits{}.max_json_depth - 1;
    return Json::parse(
        StrictJsonObject::parse(manifest.evidence_json, max_depth, "evidence").json_text());
}

}  // namespace

std::string manifest_text(const Manifest& manifest) {
    Json views = Json::array();
    for (const ManifestView& view : manifest.views) views.push_back(json_of(view));
    Json document = {{"format", kPackageFormat},
                     {"schema_version", kPackageSchemaVersion},
                     {kManifestChecksumKey, std::string(kChecksumDigits, '0')},
                     {"name", manifest.name},
                     {"blending_space", kBlendingSpace},
                     {"near_depth", manifest.near_depth},
                     {"far_depth", manifest.far_depth},
                     {"camera_mesh", json_of(manifest.camera_mesh)},
                     {"points", json_of(manifest.points)},
                     {"config", json_of(manifest.config)},
                     {"views", views},
                     {"evidence", evidence_of(manifest)}};
    if (manifest.noisy_depth_error_px != kNoisyDepthError_px)
        document["noisy_depth_error_px"] = manifest.noisy_depth_error_px;
    if (manifest.light_falloff != 0) document["light_falloff"] = manifest.light_falloff;
    for_each_drawing_choice([&](const auto& choice) {
        const auto value = manifest.drawing.*choice.member;
        if (value != DrawingChoices{}.*choice.member) document[choice.name] = value;
    });
    try {
        return with_manifest_checksum(document.dump(1) + "\n").value();
    } catch (const Json::exception&) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-NAME",
                    printable(manifest.name) + ": the name of a photograph is not UTF-8",
                    "rename the photographs with letters that UTF-8 knows");
    }
}

std::optional<std::string> with_manifest_checksum(std::string text) {
    const std::string field = "\"" + std::string(kManifestChecksumKey) + "\": \"";
    const std::size_t found = text.find(field);
    if (found == std::string::npos) return std::nullopt;
    const std::size_t begin = found + field.size();
    if (text.size() < begin + kChecksumDigits) return std::nullopt;
    text.replace(begin, kChecksumDigits, kChecksumDigits, '0');
    text.replace(begin, kChecksumDigits, sha256_hex(text));
    return text;
}

}  // namespace lumi
