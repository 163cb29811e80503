#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "calib/work/whole_file.h"
#include "render/lumigraph/manifest.h"

namespace lumi {

/// Whether `path` names a file below a package and nothing else, on any file system: lower-case
/// letters, digits, '_', '-' and '/', no empty part, no part that begins with a dot or names a
/// device, and one of the endings .png, .ply, .mesh and .toml.
[[nodiscard]] bool is_safe_package_path(std::string_view path);

/// The open folder of a package. Files are opened part by part from it, without following a link,
/// so that no path leaves it, whatever happens to the folder meanwhile. Safe to read from several
/// threads.
class PackageFolder {
 public:
    /// Throws Error (E-PACKAGE-MISSING; -ACCESS for what the system keeps from being read).
    explicit PackageFolder(const std::filesystem::path& folder);
    ~PackageFolder();
    PackageFolder(const PackageFolder&) = delete;
    PackageFolder& operator=(const PackageFolder&) = delete;

    /// For messages.
    [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
    [[nodiscard]] std::filesystem::path path_of(const PackageFile& file) const;
    /// The bytes of a file whose length and checksum are those of the manifest. Throws Error
    /// (E-PACKAGE-MISSING, -ACCESS, -PATH, -SIZE, -CHECKSUM).
    [[nodiscard]] Bytes read(const PackageFile& file) const;
    /// The bytes of a plain file of at most `max_bytes`. Throws Error (E-PACKAGE-MISSING,
    /// -ACCESS, -PATH, -SIZE).
    [[nodiscard]] Bytes read_unchecked(std::string_view path, std::uint64_t max_bytes) const;

 private:
    std::filesystem::path folder_;
    int descriptor_ = -1;
};

/// The manifest of an open package.
[[nodiscard]] Manifest read_manifest(const PackageFolder& package, const PackageLimits& limits);

}  // namespace lumi
