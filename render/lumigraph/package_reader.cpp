#include <new>

#include "calib/pictures/image_format.h"
#include "calib/pictures/png_codec.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "meshing/surface/mesh_io.h"
#include "render/lumigraph/deflate.h"
#include "render/lumigraph/even_exposure.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package.h"
#include "render/lumigraph/package_folder.h"
#include "render/lumigraph/package_memory.h"
#include "render/lumigraph/quantised_depth.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

/// The bytes of a PNG whose header states the size that the manifest states.
Bytes read_png_bytes(const PackageFolder& package, const PackageFile& file, int width_px,
                     int height_px) {
    const fs::path path = package.path_of(file);
    Bytes bytes = package.read(file);
    if (image_format_of(bytes) != ImageFormat::kPng) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-FORMAT", path.string() + ": expected a PNG",
                    "packages hold PNG pictures only: build it again with `lumi build`");
    }
    const ImageSize size = check_png(bytes, path);
    if (size.width_px != width_px || size.height_px != height_px) {
        throw Error(ErrorKind::kBadInput, "E-PACKAGE-SIZE",
                    path.string() + ": " + std::to_string(size.width_px) + "x" +
                        std::to_string(size.height_px) + " pixels, expected " +
                        std::to_string(width_px) + "x" + std::to_string(height_px),
                    "the package is damaged: build it again with `lumi build`");
    }
    return bytes;
}

DepthMap read_depth(const PackageFolder& package, const ManifestDepth& entry) {
    const int width_px = entry.width_px;
    const int height_px = entry.height_px;
    const Bytes steps = read_png_bytes(package, entry.inverse_depth, width_px, height_px);
    const Bytes confidence = read_png_bytes(package, entry.confidence, width_px, height_px);
    return {dequantise({decode_gray16_png(steps, kMaxPixelsPerPicture,
                                          package.path_of(entry.inverse_depth)),
                        entry.min_inverse_depth, entry.max_inverse_depth}),
            decode_gray_png(confidence, kMaxPixelsPerPicture, package.path_of(entry.confidence))};
}

std::shared_ptr<const DepthMesh> read_depth_mesh(const PackageFolder& package,
                                                 const ManifestView& entry) {
    const ManifestDepthMesh& mesh = *entry.depth->mesh;
    const std::string where = package.path_of(mesh.file).string();
    const Bytes code = inflated(package.read(mesh.file), mesh.code_bytes, where);
    return std::make_shared<const DepthMesh>(decode({mesh.header, code}, entry.camera, where));
}

LumigraphView read_view(const PackageFolder& package, const ManifestView& entry) {
    const Bytes png =
        read_png_bytes(package, entry.photograph, entry.camera.width_px, entry.camera.height_px);
    LumigraphView view;
    view.name = entry.name;
    view.camera = entry.camera;
    view.cam_from_world = entry.cam_from_world;
    view.exif_orientation = entry.exif_orientation;
    view.exposure_gain = entry.exposure_gain;
    view.photograph =
        decode_color_png(png, kMaxPixelsPerPicture, package.path_of(entry.photograph));
    if (entry.depth) view.depth = read_depth(package, *entry.depth);
    if (entry.depth && entry.depth->mesh) view.depth_mesh = read_depth_mesh(package, entry);
    return view;
}

Lumigraph read_contents(const fs::path& folder, const PackageLimits& limits) {
    const PackageFolder package(folder);
    const Manifest manifest = read_manifest(package, limits);
    expect_readable(manifest, folder, limits);

    Lumigraph lumigraph;
    lumigraph.name = manifest.name;
    lumigraph.near_depth = manifest.near_depth;
    lumigraph.far_depth = manifest.far_depth;
    lumigraph.noisy_depth_error_px = manifest.noisy_depth_error_px;
    lumigraph.drawing = manifest.drawing;
    lumigraph.light_falloff = manifest.light_falloff;
    lumigraph.mesh = parse_camera_mesh_ply(package.read(manifest.camera_mesh),
                                           package.path_of(manifest.camera_mesh));
    // Not part of the Lumigraph, but a package with a damaged file is a damaged package.
    static_cast<void>(package.read(manifest.points));
    static_cast<void>(package.read(manifest.config));

    lumigraph.views.resize(manifest.views.size());
    parallel_for(static_cast<int>(manifest.views.size()), 0, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        lumigraph.views[index] = read_view(package, manifest.views[index]);
    });
    validate(lumigraph, folder.string());
    return lumigraph;
}

}  // namespace

Lumigraph read_package(const fs::path& folder, const PackageLimits& limits, Exposures exposures) {
    try {
        Lumigraph lumigraph = read_contents(folder, limits);
        if (exposures == Exposures::kEvened) even_exposures(lumigraph);
        return lumigraph;
    } catch (const Error& error) {
        if (error.code().starts_with("E-PACKAGE-")) throw;
        throw Error(error.kind(), "E-PACKAGE-CONTENT", error.what(),
                    "the package is damaged: copy it again, or build it again with `lumi build`");
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::kResources, "E-PACKAGE-MEMORY",
                    folder.string() + ": not enough memory to read it",
                    "close other programs, or build the package from smaller photographs");
    }
}

}  // namespace lumi
