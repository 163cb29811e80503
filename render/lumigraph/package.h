#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/capture.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// What else goes into a package, as it is.
struct PackageExtras {
    std::string resolved_config_toml;
    std::string evidence_json = "{}";  ///< A JSON object: what speaks for each stage.
    std::vector<ScenePoint> points;    ///< Written as points.ply.
};

/// Memory that reading a package may take whatever the machine has.
inline constexpr std::uint64_t kLeastMemoryOfPackages = std::uint64_t{8} << 30;

/// The machine's memory, but at least kLeastMemoryOfPackages.
[[nodiscard]] std::uint64_t most_memory_of_packages();

/// Limits that a reader keeps to, whatever the package claims.
struct PackageLimits {
    /// The most memory that reading may take: what is decoded, and files while they are held
    /// (package_memory.h).
    std::uint64_t max_decoded_bytes = most_memory_of_packages();
    std::size_t max_views = 10'000;
    std::size_t max_manifest_bytes = std::size_t{16} << 20;
    int max_json_depth = 32;
};

/// Writes `NAME.lumi/` whole or not at all: a temporary sibling folder, every file flushed, then
/// one exchange with what is there; an existing package is replaced at that moment and not before.
/// Files in it that no package has, such as screenshots, are kept. The same bytes for the same
/// input: no times, no machine paths, unless the extras hold any. Throws Error: E-PACKAGE-WRITE
/// (something else stands there), E-PACKAGE-NAME (not UTF-8), E-PACKAGE-MANIFEST (the evidence is
/// no JSON object), E-PACKAGE-BUDGET (a reader that keeps to `max_decoded_bytes` could not read
/// it), E-FILE-READ, E-FILE-WRITE, and those of `validate`.
void write_package(const std::filesystem::path& folder, const Lumigraph& lumigraph,
                   const PackageExtras& extras, const PackageLimits& limits = {});

/// Whether `name`, below a package and '/' between folders, is that of a file which write_package
/// writes.
[[nodiscard]] bool is_name_in_package(const std::string& name);

/// How the photographs of a package come into memory.
enum class Exposures {
    kEvened,   ///< Each in the exposure of those around it (even_exposure.h).
    kAsTaken,  ///< As they are in the files, their gains beside them.
};

/// Reads a package and trusts nothing in it (design: paths stay beneath the package, formats are
/// whitelisted, sizes are checked in 64 bits before decoding, checksums, finite numbers, indices in
/// range). Throws Error (E-PACKAGE-...) that names the file and what was expected.
[[nodiscard]] Lumigraph read_package(const std::filesystem::path& folder,
                                     const PackageLimits& limits = {},
                                     Exposures exposures = Exposures::kEvened);

}  // namespace lumi
