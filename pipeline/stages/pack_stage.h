#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/ingest/ingest.h"
#include "pipeline/workspace/done_marker.h"

namespace lumi {

/// Where the pack stage finds what it packs, and what else goes in.
struct PackSources {
    std::string name;
    PosedPhotographs photographs;  ///< The views in use.
    std::vector<Photograph> ingested;
    std::vector<std::string> held_out;
    std::filesystem::path mesh_folder;
    std::filesystem::path depth_folder;
    std::string poses_sha256;  ///< Of the poses stage's pinhole model and pictures.
    std::string resolved_config_toml;
    std::string evidence_json;
};

/// Everything -> the package at `package_folder`, and pack.json (PackRecord) in
/// `folder`.
[[nodiscard]] StageEvidence run_pack_stage(const PackSources& sources,
                                           const std::filesystem::path& package_folder,
                                           const std::filesystem::path& folder, int threads,
                                           Progress& progress);

/// What the package was made from.
struct PackRecord {
    std::vector<std::string> held_out;  ///< Views it was made without, sorted by name.
    std::string poses_sha256;
};
/// Throws Error (E-JSON-READ).
[[nodiscard]] PackRecord read_pack_record(const std::filesystem::path& pack_folder);

}  // namespace lumi
