#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

#include "calib/capture/image_io.h"
#include "calib/work/content_hash.h"
#include "calib/work/error.h"
#include "calib/work/whole_file.h"
#include "meshing/surface/mesh_io.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package.h"
#include "render/lumigraph/quantised_depth.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& what) {
    throw Error(ErrorKind::kResources, "E-PACKAGE-WRITE", path.string() + ": " + what,
                "free some disk space, check that you may write there, and run the command again");
}

std::string numbered(const char* folder, std::size_t index, const char* ending) {
    char name[64];
    std::snprintf(name, sizeof(name), "%s/%06zu%s", folder, index + 1, ending);
    return name;
}

/// A file that has been written, as the manifest lists it.
PackageFile listed(const fs::path& root, const std::string& path) {
    return {path, fs::file_size(root / path), sha256_hex_of_file(root / path)};
}

ManifestView write_view(const fs::path& root, std::size_t index, const LumigraphView& view) {
    ManifestView entry;
    entry.name = view.name;
    entry.camera = view.camera;
    entry.cam_from_world = view.cam_from_world;
    entry.exif_orientation = view.exif_orientation;
    const std::string photograph = numbered("views", index, ".png");
    write_png(root / photograph, view.photograph);
    entry.photograph = listed(root, photograph);
    if (view.depth.inverse_depth.empty()) return entry;

    const QuantisedDepth quantised = quantise(view.depth.inverse_depth);
    const std::string depth = numbered("depth", index, ".png");
    const std::string confidence = numbered("depth", index, "_confidence.png");
    write_png(root / depth, quantised.steps);
    write_png(root / confidence, view.depth.confidence);
    entry.has_depth = true;
    entry.inverse_depth = listed(root, depth);
    entry.confidence = listed(root, confidence);
    entry.depth_width_px = view.depth.inverse_depth.width();
    entry.depth_height_px = view.depth.inverse_depth.height();
    entry.min_inverse_depth = quantised.min_inverse_depth;
    entry.max_inverse_depth = quantised.max_inverse_depth;
    return entry;
}

void write_contents(const fs::path& root, const Lumigraph& lumigraph, const PackageExtras& extras) {
    Manifest manifest;
    manifest.name = lumigraph.name;
    manifest.near_depth = lumigraph.near_depth;
    manifest.far_depth = lumigraph.far_depth;
    manifest.evidence_json = extras.evidence_json;
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        manifest.views.push_back(write_view(root, i, lumigraph.views[i]));
    }
    write_camera_mesh_ply(root / "camera_mesh.ply", lumigraph.mesh);
    write_points_ply(root / "points.ply", extras.points);
    write_whole_text(root / "config.toml", extras.resolved_config_toml);
    manifest.camera_mesh = listed(root, "camera_mesh.ply");
    manifest.points = listed(root, "points.ply");
    manifest.config = listed(root, "config.toml");
    write_whole_text(root / "lumigraph.json", manifest_text(manifest));
}

/// Puts `fresh` where `target` is in one step: whoever looks finds the old package or the new one.
void swap_into_place(const fs::path& fresh, const fs::path& target) {
    if (!fs::exists(target)) {
        if (::rename(fresh.c_str(), target.c_str()) != 0) refuse(target, std::strerror(errno));
        return;
    }
    if (::renameat2(AT_FDCWD, fresh.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) != 0) {
        // Some file systems cannot exchange; there a moment without a package is unavoidable.
        const fs::path old = target.string() + ".old";
        fs::remove_all(old);
        if (::rename(target.c_str(), old.c_str()) != 0) refuse(target, std::strerror(errno));
        if (::rename(fresh.c_str(), target.c_str()) != 0) refuse(target, std::strerror(errno));
        fs::remove_all(old);
    }
    fs::remove_all(fresh);
}

void validate(const Lumigraph& lumigraph, const fs::path& folder) {
    if (lumigraph.views.empty()) refuse(folder, "there is no view to write");
    validate(lumigraph.mesh, static_cast<int>(lumigraph.views.size()), folder.string());
}

}  // namespace

void write_package(const fs::path& folder, const Lumigraph& lumigraph,
                   const PackageExtras& extras) {
    validate(lumigraph, folder);
    const fs::path fresh = folder.string() + ".tmp";
    try {
        fs::remove_all(fresh);
        fs::create_directories(fresh);
        write_contents(fresh, lumigraph, extras);
        swap_into_place(fresh, folder);
    } catch (const fs::filesystem_error& error) {
        refuse(folder, error.what());
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(fresh, ignored);
        throw;
    }
}

}  // namespace lumi
