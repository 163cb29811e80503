#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>

#include "render/lumigraph/package.h"

namespace lumi {

/// Three cameras with random pixels, depth and odd poses, whose files together hold a few KiB; the
/// third view has no depth, the first alone a depth mesh. The same for the same seed.
[[nodiscard]] Lumigraph tiny_lumigraph(unsigned seed = 1);
[[nodiscard]] PackageExtras tiny_extras();

/// Makes a file anew without flushing it: quicker than write_whole_file by a disk's latency.
void put_file(const std::filesystem::path& path, const std::string& bytes);

/// Changes the manifest of a package and makes its checksum right again, as a forger would.
void forge_manifest(const std::filesystem::path& package,
                    const std::function<void(nlohmann::ordered_json&)>& change);

/// Gives a file of the package other bytes and the manifest the length and checksum of them.
/// `listing` is the JSON pointer of the file's entry, such as "/views/0/photograph".
void forge_file(const std::filesystem::path& package, const std::string& listing,
                const std::string& bytes);

/// The code of the Error that reading the package throws; empty when it is read.
[[nodiscard]] std::string code_of_reading(const std::filesystem::path& package,
                                          const PackageLimits& limits = {});

}  // namespace lumi
