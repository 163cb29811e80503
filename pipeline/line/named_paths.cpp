#include "pipeline/line/named_paths.h"

#include "calib/work/error.h"
#include "calib/work/printable.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

enum class Kind { kFile, kFolder, kEither };

void expect_path(const char* key, const fs::path& path, Kind kind) {
    std::error_code status;
    if (path.empty()) return;
    const bool is_there = kind == Kind::kFile     ? fs::is_regular_file(path, status)
                          : kind == Kind::kFolder ? fs::is_directory(path, status)
                                                  : fs::exists(path, status);
    if (is_there) return;
    const char* wanted = kind == Kind::kFile     ? "file"
                         : kind == Kind::kFolder ? "folder"
                                                 : "file or folder";
    throw Error(ErrorKind::kBadInput, "E-CONFIG-PATH",
                "`" + std::string(key) + "`: no such " + wanted + ": " + printable(path.string()),
                "correct this key of the configuration, or remove it; paths are relative to the "
                "configuration");
}

/// A folder of which every view needs something.
void expect_filled(const char* key, const fs::path& folder) {
    std::error_code status;
    if (folder.empty() || !fs::is_empty(folder, status)) return;
    throw Error(ErrorKind::kBadInput, "E-CONFIG-PATH",
                "`" + std::string(key) + "`: nothing is in " + printable(folder.string()),
                "put there what this key of the configuration is to bring, or remove it; paths are "
                "relative to the configuration");
}

}  // namespace

void expect_named_paths(const BuildConfig& config, const std::string& last_stage) {
    if (last_stage == "ingest") return;
    expect_path("calibration.boards", config.boards, Kind::kEither);
    expect_path("capture.import", config.imported_poses, Kind::kEither);
    expect_path("poses.masks", config.poses.mask_folder, Kind::kFolder);
    if (last_stage == "poses" || last_stage == "mesh") return;
    expect_path("depth.import_folder", config.depth.import_folder, Kind::kFolder);
    expect_filled("depth.import_folder", config.depth.import_folder);
    expect_path("depth.import_mesh", config.depth.import_mesh, Kind::kFile);
    expect_path("depth.import_volume", config.depth.import_volume, Kind::kFile);
    expect_path("depth.masks", config.depth.mask_folder, Kind::kFolder);
}

}  // namespace lumi
