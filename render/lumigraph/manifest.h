#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"

namespace lumi {

/// The version of the package's layout; a reader refuses any other.
inline constexpr int kPackageVersion = 1;

/// A file of the package: its path below the package, its length and its SHA-256.
struct PackageFile {
    std::string path;
    std::uint64_t bytes = 0;
    std::string sha256;
};

/// What the manifest says of one view.
struct ManifestView {
    std::string name;
    Camera camera;
    Rigid3 cam_from_world;
    int exif_orientation = 1;
    PackageFile photograph;

    bool has_depth = false;
    PackageFile inverse_depth;  ///< 16-bit PNG: q = min + value / 65535 * (max - min).
    PackageFile confidence;     ///< 8-bit PNG of the same size.
    int depth_width_px = 0;
    int depth_height_px = 0;
    double min_inverse_depth = 0.0;
    double max_inverse_depth = 0.0;
};

/// `lumigraph.json`: what is in a package, and how to read it.
struct Manifest {
    std::string name;
    double near_depth = 0.0;
    double far_depth = 0.0;
    std::vector<ManifestView> views;
    PackageFile camera_mesh;
    PackageFile points;
    PackageFile config;
    std::string evidence_json = "{}";
};

/// The manifest as JSON text: sorted keys, doubles that read back to the bit.
[[nodiscard]] std::string manifest_text(const Manifest& manifest);

/// Reads a manifest and trusts nothing in it: bounded depth, the version, finite numbers, positive
/// sizes, rotations of unit length, safe paths. Throws Error (E-PACKAGE-MANIFEST,
/// E-PACKAGE-VERSION, E-PACKAGE-PATH).
[[nodiscard]] Manifest parse_manifest(std::string_view text, int max_json_depth,
                                      std::size_t max_views);

/// Whether `path` names a file below the package and nothing else: plain ASCII names between single
/// slashes, no dots at a name's start, and one of the endings png, ply, toml.
[[nodiscard]] bool is_safe_package_path(std::string_view path);

}  // namespace lumi
