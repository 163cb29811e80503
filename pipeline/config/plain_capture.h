#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace lumi {

/// Bytes of the longest name that a build may have.
inline constexpr std::size_t kMaxBuildName = 100;

/// A capture that is named itself instead of a configuration: all else has its default.
struct PlainCapture {
    std::string key;   ///< Of [capture]: "photos" for a folder, "video" for a file.
    std::string name;  ///< For the build: nearly that of the folder or the file.
};

/// None where the path names a configuration, or nothing: a file that is not named *.toml and is
/// named like a video, or has a zero byte in its first four KiB, as every video has, is taken for a
/// video. Throws Error: E-CONFIG-PHOTOGRAPH for a single photograph; E-CONFIG-PACKAGE,
/// E-CONFIG-WORKSPACE for the folder of a package and for a workspace, whose pictures are no
/// capture, unless its photographs lie in that folder, too; E-CONFIG-NAME
/// where the path is not UTF-8, which a configuration could not name.
[[nodiscard]] std::optional<PlainCapture> plain_capture(const std::filesystem::path& path);

/// Configurations, which are UTF-8, name what lies beside them by its whole path. Throws Error
/// (E-CONFIG-NAME) where this one is not UTF-8.
void expect_utf8(const std::filesystem::path& absolute);

}  // namespace lumi
