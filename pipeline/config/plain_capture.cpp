#include "pipeline/config/plain_capture.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "calib/pictures/image_format.h"
#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"
#include "meshing/surface/file_ending.h"
#include "render/lumigraph/manifest.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

bool has_zero_byte_at_its_beginning(const fs::path& file) {
    std::array<char, 4096> beginning{};
    std::ifstream stream(file, std::ios::binary);
    stream.read(beginning.data(), beginning.size());
    const auto end = beginning.begin() + stream.gcount();
    return std::find(beginning.begin(), end, '\0') != end;
}

/// Also of a file that is no video, so that it is not read as a configuration.
bool is_named_like_a_video(const fs::path& file) {
    constexpr std::array<const char*, 10> kEndings{".3gp", ".avi", ".m4v",  ".mkv", ".mov",
                                                   ".mp4", ".mpg", ".mpeg", ".mts", ".webm"};
    const std::string ending = lower_case_ending(file);
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

/// Whether the folder is a workspace, and not among the photographs that it was made of.
bool is_workspace_of_another_capture(const fs::path& folder) {
    std::error_code status;
    const fs::path config = folder / "config.toml";
    if (!fs::exists(config, status) || !fs::exists(folder / "stages.json", status)) return false;
    const fs::path photos = ConfigSection::from_file(config).section("capture").path("photos");
    return !fs::equivalent(photos, folder, status);
}

/// A name that a build may have (is_plain_name), as near to a file's as can be.
std::string build_name_of(const std::string& file_name) {
    std::string name = printable(file_name);
    std::replace(name.begin(), name.end(), '\\', '_');
    name.erase(0, name.find_first_not_of('.'));
    if (name.size() > kMaxBuildName) {
        std::size_t end = kMaxBuildName;
        const auto is_within_letter = [&](std::size_t at) {
            return (static_cast<unsigned char>(name[at]) & 0xC0U) == 0x80U;
        };
        while (is_within_letter(end)) --end;
        name.resize(end);
    }
    return name.empty() ? "capture" : name;
}

}  // namespace

void expect_utf8(const fs::path& absolute) {
    if (is_utf8(absolute.string())) return;
    throw Error(ErrorKind::kBadInput, "E-CONFIG-NAME",
                printable(absolute.string()) + ": the name of a folder or of the file is not UTF-8",
                "rename the folder or the file: what is no text in its name stands as \\x above");
}

std::optional<PlainCapture> plain_capture(const fs::path& path) {
    std::error_code status;
    if (fs::is_directory(path, status)) {
        if (fs::exists(path / kManifestName, status)) {
            throw Error(
                ErrorKind::kBadInput, "E-CONFIG-PACKAGE",
                path.string() + ": is a package, expected photographs",
                "see it with lumi view; to build it again give its workspace's config.toml");
        }
        if (is_workspace_of_another_capture(path)) {
            throw Error(ErrorKind::kBadInput, "E-CONFIG-WORKSPACE",
                        path.string() + ": is a workspace of lumi, expected photographs",
                        "give its configuration, " + (path / "config.toml").string() +
                            "; to build there again, lumi build with --workspace " + path.string());
        }
        const fs::path folder = fs::absolute(path).lexically_normal();
        expect_utf8(folder);
        const fs::path named = folder.has_filename() ? folder : folder.parent_path();
        return PlainCapture{"photos", build_name_of(named.filename().string())};
    }
    if (path.extension() == ".toml" || !fs::is_regular_file(path, status)) return std::nullopt;
    if (image_format_of(path)) {
        throw Error(ErrorKind::kBadInput, "E-CONFIG-PHOTOGRAPH",
                    path.string() + ": is one photograph, expected a folder of them",
                    "give the folder that it lies in");
    }
    if (!is_named_like_a_video(path) && !has_zero_byte_at_its_beginning(path)) return std::nullopt;
    expect_utf8(fs::absolute(path));
    return PlainCapture{"video", build_name_of(path.stem().string())};
}

}  // namespace lumi
