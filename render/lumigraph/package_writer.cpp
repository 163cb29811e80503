#include <cstdio>
#include <filesystem>

#include "calib/pictures/png_codec.h"
#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "calib/work/whole_file.h"
#include "calib/work/whole_folder.h"
#include "meshing/surface/mesh_io.h"
#include "meshing/surface/points_ply.h"
#include "render/lumigraph/deflate.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package.h"
#include "render/lumigraph/package_memory.h"
#include "render/lumigraph/quantised_depth.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMeshName = "camera_mesh.ply";
constexpr const char* kPointsName = "points.ply";
constexpr const char* kConfigName = "config.toml";

/// The files of a view.
struct NumberedFile {
    const char* folder;
    const char* ending;
};
constexpr NumberedFile kPhotograph{"views", ".png"};
constexpr NumberedFile kDepthSteps{"depth", ".png"};
constexpr NumberedFile kConfidence{"depth", "_confidence.png"};
constexpr NumberedFile kDepthMesh{"depth", ".mesh"};

std::string numbered(const NumberedFile& file, std::size_t index) {
    char name[64];
    std::snprintf(name, sizeof(name), "%s/%06zu%s", file.folder, index + 1, file.ending);
    return name;
}

bool is_numbered(const std::string& name, const NumberedFile& file) {
    const std::size_t number_at = std::string(file.folder).size() + 1;
    std::size_t number = 0;
    return name.size() > number_at && std::sscanf(name.c_str() + number_at, "%zu", &number) == 1 &&
           number > 0 && name == numbered(file, number - 1);
}

/// Writes a file of the package and returns it as the manifest lists it.
PackageFile write_listed(const fs::path& root, const std::string& path, const Bytes& bytes) {
    write_whole_file(root / path, bytes);
    return {path, bytes.size(), sha256_hex(bytes)};
}

ManifestDepthMesh write_depth_mesh(const fs::path& root, std::size_t index,
                                   const LumigraphView& view) {
    const CodedDepthMesh coded = encode(*view.depth_mesh, view.camera);
    return {coded.header, coded.bytes.size(),
            write_listed(root, numbered(kDepthMesh, index), deflated(coded.bytes))};
}

ManifestDepth write_depth(const fs::path& root, std::size_t index, const LumigraphView& view) {
    const DepthMap& depth = view.depth;
    const QuantisedDepth quantised = quantise(depth.inverse_depth);
    const std::string steps = numbered(kDepthSteps, index);
    const std::string confidence = numbered(kConfidence, index);
    ManifestDepth entry{
        depth.inverse_depth.width(),
        depth.inverse_depth.height(),
        quantised.min_inverse_depth,
        quantised.max_inverse_depth,
        write_listed(root, steps, encode_png(quantised.steps, root / steps)),
        write_listed(root, confidence, encode_png(depth.confidence, root / confidence)),
        std::nullopt};
    if (view.depth_mesh) entry.mesh = write_depth_mesh(root, index, view);
    return entry;
}

ManifestView write_view(const fs::path& root, std::size_t index, const LumigraphView& view) {
    const std::string photograph = numbered(kPhotograph, index);
    ManifestView entry;
    entry.name = view.name;
    entry.camera = view.camera;
    entry.cam_from_world = view.cam_from_world;
    entry.exif_orientation = view.exif_orientation;
    entry.exposure_gain = view.exposure_gain;
    entry.photograph =
        write_listed(root, photograph, encode_png(view.photograph, root / photograph));
    if (view.has_depth()) entry.depth = write_depth(root, index, view);
    return entry;
}

Manifest write_contents(const fs::path& root, const Lumigraph& lumigraph,
                        const PackageExtras& extras) {
    Manifest manifest;
    manifest.name = lumigraph.name;
    manifest.near_depth = lumigraph.near_depth;
    manifest.far_depth = lumigraph.far_depth;
    manifest.noisy_depth_error_px = lumigraph.noisy_depth_error_px;
    manifest.drawing = lumigraph.drawing;
    manifest.light_falloff = lumigraph.light_falloff;
    manifest.evidence_json = extras.evidence_json;
    manifest.views.resize(lumigraph.views.size());
    parallel_for(static_cast<int>(lumigraph.views.size()), 0, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        manifest.views[index] = write_view(root, index, lumigraph.views[index]);
    });
    const std::string& config = extras.resolved_config_toml;
    manifest.camera_mesh = write_listed(root, kMeshName, camera_mesh_ply(lumigraph.mesh));
    manifest.points = write_listed(root, kPointsName, points_ply(extras.points));
    manifest.config = write_listed(root, kConfigName, {config.begin(), config.end()});
    write_whole_text(root / kManifestName, manifest_text(manifest));
    return manifest;
}

/// Only a package gives way to a package: a mistyped path must not cost a folder of photographs.
void expect_package_or_nothing(const fs::path& folder) {
    if (!fs::exists(folder) || fs::exists(folder / kManifestName)) return;
    if (fs::is_directory(folder) && fs::is_empty(folder)) return;
    throw Error(ErrorKind::kBadInput, "E-PACKAGE-WRITE",
                folder.string() + ": is there already and is not a package",
                "choose another name, or remove it first");
}

}  // namespace

bool is_name_in_package(const std::string& name) {
    for (const char* single : {kManifestName, kMeshName, kPointsName, kConfigName}) {
        if (name == single) return true;
    }
    for (const NumberedFile& file : {kPhotograph, kDepthSteps, kConfidence, kDepthMesh}) {
        if (is_numbered(name, file)) return true;
    }
    return false;
}

void write_package(const fs::path& folder, const Lumigraph& lumigraph, const PackageExtras& extras,
                   const PackageLimits& limits) {
    validate(lumigraph, folder.string());
    expect_package_or_nothing(folder);
    WholeFolder package(folder);
    expect_readable(write_contents(package.staging(), lumigraph, extras), folder, limits);
    package.keep_files_of_others(is_name_in_package);
    package.put_in_place();
}

}  // namespace lumi
