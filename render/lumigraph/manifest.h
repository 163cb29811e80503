#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/rigid3.h"
#include "render/lumigraph/coded_depth_mesh.h"
#include "render/lumigraph/package.h"

namespace lumi {

/// The version of the package's layout; a reader refuses any other.
inline constexpr int kPackageSchemaVersion = 1;

/// The manifest's name in the package.
inline constexpr const char* kManifestName = "lumigraph.json";

/// A file of the package: its path below the package, its length and its SHA-256.
struct PackageFile {
    std::string path;
    std::uint64_t bytes = 0;
    std::string sha256;
};

/// Where the triangles of a view's depth are stored, in the code of coded_depth_mesh.h.
struct ManifestDepthMesh {
    CodedDepthMeshHeader header;
    std::uint64_t code_bytes = 0;  ///< Inflated.
    PackageFile file;              ///< Deflated (RFC 1950).
};

/// Where one view's depth is stored, and how: q = min + step / 65535 * (max - min) for the `step`
/// of each pixel of the 16-bit picture.
struct ManifestDepth {
    int width_px = 0;
    int height_px = 0;
    double min_inverse_depth = 0.0;
    double max_inverse_depth = 0.0;
    PackageFile inverse_depth;  ///< 16-bit grey PNG.
    PackageFile confidence;     ///< 8-bit grey PNG of the same size.
    /// Not in packages of before, or without need: it is made of the two others.
    std::optional<ManifestDepthMesh> mesh;
};

/// What the manifest says of one view.
struct ManifestView {
    std::string name;
    Camera camera;
    Rigid3 cam_from_world;
    int exif_orientation = 1;
    PackageFile photograph;
    ExposureGain exposure_gain = kNoExposureGain;
    std::optional<ManifestDepth> depth;
};

/// `lumigraph.json`: what is in a package, and how to read it.
struct Manifest {
    std::string name;
    double near_depth = 0.0;
    double far_depth = 0.0;
    double noisy_depth_error_px = kNoisyDepthError_px;
    DrawingChoices drawing;
    double light_falloff = 0.0;
    std::vector<ManifestView> views;
    PackageFile camera_mesh;
    PackageFile points;
    PackageFile config;
    std::string evidence_json = "{}";
};

/// The manifest as JSON text that names its own checksum; doubles read back to the bit. Throws
/// Error: E-PACKAGE-NAME (a name is not UTF-8), E-PACKAGE-MANIFEST (the evidence is not a JSON
/// object of bounded depth).
[[nodiscard]] std::string manifest_text(const Manifest& manifest);

/// Reads a manifest and trusts nothing in it: its checksum, bounded depth, the version, finite
/// numbers, positive sizes, rotations of unit length, safe paths. `where` begins each message.
/// Throws Error (E-PACKAGE-MANIFEST, -VERSION, -CHECKSUM, -PATH).
[[nodiscard]] Manifest parse_manifest(std::string_view text, const PackageLimits& limits,
                                      const std::string& where = kManifestName);

/// The manifest of the package in `folder`; also throws E-PACKAGE-MISSING, -ACCESS and
/// -SIZE.
[[nodiscard]] Manifest read_manifest(const std::filesystem::path& folder,
                                     const PackageLimits& limits = {});

/// The text with its `manifest_sha256` set: the SHA-256 of the whole text with 64 zeros in the
/// place of that checksum. Empty when the text has no such field.
[[nodiscard]] std::optional<std::string> with_manifest_checksum(std::string text);

}  // namespace lumi
