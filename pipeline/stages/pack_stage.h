#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "calib/capture/posed_photographs.h"
#include "calib/ingest/ingest.h"
#include "pipeline/config/build_config.h"
#include "pipeline/stages/drawing_effort.h"
#include "pipeline/workspace/done_marker.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// Where the pack stage finds what it packs, and what else goes in.
struct PackSources {
    std::string name;
    PosedPhotographs photographs;  ///< The views in use.
    std::vector<Photograph> ingested;
    std::vector<std::string> held_out;
    std::filesystem::path mesh_folder;
    std::filesystem::path depth_folder;
    std::string pictures_sha256;       ///< Of all pictures, and of the poses stage's pinhole model.
    std::string mesh_sha256;           ///< Of what the mesh stage wrote.
    std::string depth_sha256;          ///< Of what the depth stage wrote.
    std::string configuration_sha256;  ///< As in stages.json (line/told_configuration.h).
    std::string resolved_config_toml;
    std::string evidence_json;
    PackageOptions options;
    DrawingOptions drawing;
    CameraMeshOptions mesh_options;  ///< For the camera mesh over fewer views.
    int max_memory_mib = 0;          ///< As for finding depth.
    /// How many views are enough; asked for when the options want the fewest.
    std::function<int(const Lumigraph& lumigraph, const Capture& capture)> sufficient_views;
    /// How closely depth meshes follow noisy depth, once they were made as the Lumigraph says; to
    /// be set, and asked whatever `drawing` says, which it knows.
    std::function<DepthMeshEffort(const Lumigraph& lumigraph, const Capture& capture)>
        depth_mesh_effort;
    /// All else about how the Lumigraph is drawn; the same.
    std::function<DrawingEfforts(const Lumigraph& lumigraph, const Capture& capture)>
        drawing_efforts;
};

/// Everything -> the package at `package_folder`, and pack.json (PackRecord) in `folder`. Where
/// fewer views are wanted, those that stand for all best go in. Throws Error (E-PACK-MIB) when not
/// even one view fits the limit.
[[nodiscard]] StageEvidence run_pack_stage(const PackSources& sources,
                                           const std::filesystem::path& package_folder,
                                           const std::filesystem::path& folder, int threads,
                                           Progress& progress);

/// What the package was made from.
struct PackRecord {
    std::vector<std::string> held_out;  ///< Views it was made without, sorted by name.
    std::string pictures_sha256;        ///< As in PackSources.
    std::string package_sha256;         ///< Of its manifest: that of another package is none of it.
    /// As in PackSources; "" in records of early versions.
    std::string mesh_sha256 = {};
    std::string depth_sha256 = {};
    std::string configuration_sha256 = {};
};
/// Throws Error (E-JSON-READ).
[[nodiscard]] PackRecord read_pack_record(const std::filesystem::path& pack_folder);

}  // namespace lumi
