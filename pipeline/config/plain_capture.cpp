#include "pipeline/config/plain_capture.h"

#include <algorithm>
#include <array>
#include <fstream>

#include "calib/work/config_section.h"
#include "calib/work/error.h"
#include "calib/work/printable.h"

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

std::optional<PlainCapture> plain_capture(const fs::path& path) {
    std::error_code status;
    if (fs::is_directory(path, status)) {
        if (fs::exists(path / "lumigraph.json", status)) {
            throw Error(
                ErrorKind::kBadInput, "E-CONFIG-PACKAGE",
                path.string() + ": is a package, expected photographs",
                "see it with lumi view; to build it again give its workspace's config.toml");
        }
        if (is_workspace_of_another_capture(path)) {
            throw Error(ErrorKind::kBadInput, "E-CONFIG-WORKSPACE",
                        path.string() + ": is a workspace of lumi, expected photographs",
                        "give its configuration, " + (path / "config.toml").string() +
                            "; with --workspace " + path.string() + " lumi builds there again");
        }
        const fs::path folder = fs::absolute(path).lexically_normal();
        const fs::path named = folder.has_filename() ? folder : folder.parent_path();
        return PlainCapture{"photos", build_name_of(named.filename().string())};
    }
    if (path.extension() != ".toml" && fs::is_regular_file(path, status) &&
        has_zero_byte_at_its_beginning(path))
        return PlainCapture{"video", build_name_of(path.stem().string())};
    return std::nullopt;
}

}  // namespace lumi
