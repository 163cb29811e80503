#include "pipeline/stages/pack_stage.h"

#include <map>
#include <nlohmann/json.hpp>

#include "calib/pictures/image_io.h"
#include "calib/work/content_hash.h"
#include "calib/work/parallel_for.h"
#include "meshing/surface/mesh_io.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/stages/depth_files.h"
#include "pipeline/stages/depth_range.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/removed_transients.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/stages/view_exposures.h"
#include "pipeline/stages/view_limit.h"
#include "pipeline/workspace/json_file.h"
#include "render/depth_mesh/view_depth_mesh.h"
#include "render/lumigraph/manifest.h"
#include "render/lumigraph/package.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path record_path(const fs::path& pack_folder) { return pack_folder / "pack.json"; }

std::vector<LumigraphView> gather_views(const PackSources& sources, int threads,
                                        Progress& progress) {
    const Capture& capture = sources.photographs.capture;
    std::map<std::string, int> orientation_of;
    for (const Photograph& photograph : sources.ingested) {
        orientation_of[photograph.name] = photograph.exif_orientation;
    }
    std::vector<DepthMap> depth_maps =
        read_depth_files(sources.depth_folder, file_stems_of_views(view_names(capture)), threads);

    std::vector<LumigraphView> views(capture.views.size());
    progress.begin("reading pictures", views.size());
    parallel_for(static_cast<int>(views.size()), threads, [&](int i) {
        progress.throw_if_interrupted();
        const auto index = static_cast<std::size_t>(i);
        const View& view = capture.views[index];
        views[index] = {view.name,
                        camera_of(capture, view),
                        view.cam_from_world,
                        orientation_of.at(view.name),
                        read_color_image(sources.photographs.picture_paths[index]),
                        std::move(depth_maps[index])};
        progress.advance();
    });
    return views;
}

void set_depth_range(Lumigraph& lumigraph) {
    const DepthRange range = depth_range_of(lumigraph.views);
    lumigraph.near_depth = range.near_depth;
    lumigraph.far_depth = range.far_depth;
}

Lumigraph gather_lumigraph(const PackSources& sources, int threads, Progress& progress) {
    Lumigraph lumigraph;
    lumigraph.name = sources.name;
    lumigraph.views = gather_views(sources, threads, progress);
    lumigraph.mesh = read_camera_mesh_ply(sources.mesh_folder / "camera_mesh.ply");
    validate(lumigraph.mesh, static_cast<int>(lumigraph.views.size()),
             (sources.mesh_folder / "camera_mesh.ply").string());
    set_depth_range(lumigraph);
    return lumigraph;
}

Json exposure_json(const ExposureGains& found, const Lumigraph& lumigraph) {
    return {{"light_falloff", lumigraph.light_falloff},
            {"light_left_in_corners", lumigraph.light_left_in_corners()},
            {"model", name_of(found.model)},
            {"pairs", found.pairs},
            {"difference_stops", found.difference_stops},
            {"remaining_stops", found.remaining_stops},
            {"largest_stops", found.largest_stops}};
}

PackageExtras extras_of(const PackSources& sources) {
    return {.resolved_config_toml = sources.resolved_config_toml,
            .evidence_json = sources.evidence_json,
            .points = sources.photographs.capture.points};
}

void write_pack_record(const fs::path& folder, const PackSources& sources,
                       const fs::path& package_folder) {
    write_json_file(record_path(folder),
                    Json{{"held_out", sources.held_out},
                         {"pictures_sha256", sources.pictures_sha256},
                         {"mesh_sha256", sources.mesh_sha256},
                         {"depth_sha256", sources.depth_sha256},
                         {"configuration_sha256", sources.configuration_sha256},
                         {"package_sha256", sha256_hex_of_file(package_folder / kManifestName)}});
}

/// With depth meshes as fine as is asked for.
DepthMeshEffort make_asked_depth_meshes(const PackSources& sources, Lumigraph& lumigraph,
                                        int threads, Progress& progress) {
    if (sources.drawing.noisy_depth_error_px != 0)
        lumigraph.noisy_depth_error_px = sources.drawing.noisy_depth_error_px;
    make_depth_meshes(lumigraph, threads, progress);
    // Whether depth tells noise, and so whether photographs are asked, the meshes say.
    const DepthMeshEffort effort =
        sources.depth_mesh_effort(lumigraph, capture_of(lumigraph, sources.photographs));
    if (effort.noisy_error_px == lumigraph.noisy_depth_error_px) return effort;
    lumigraph.noisy_depth_error_px = effort.noisy_error_px;
    make_depth_meshes(lumigraph, threads, progress);
    return effort;
}

}  // namespace

StageEvidence run_pack_stage(const PackSources& sources, const fs::path& package_folder,
                             const fs::path& folder, int threads, Progress& progress) {
    Lumigraph lumigraph = gather_lumigraph(sources, threads, progress);
    const PackageExtras extras = extras_of(sources);
    const auto views_in_use = static_cast<int>(lumigraph.views.size());
    Json transients = Json::array();
    if (!sources.options.keep_transients) {
        transients =
            remove_transients(lumigraph, folder, threads, sources.max_memory_mib, progress);
        set_depth_range(lumigraph);
    }
    lumigraph.drawing.fade_beyond_capture = sources.drawing.fade_beyond_capture;
    ViewExposures exposures;
    if (sources.drawing.even_exposure) {
        exposures = find_exposures(lumigraph, threads, progress);
        even_among_neighbours(exposures, lumigraph);
    }
    ViewLimit limit(sources, extras, exposures, folder, threads, progress);
    limit.keep_to_count(lumigraph);
    const DepthMeshEffort of_meshes =
        make_asked_depth_meshes(sources, lumigraph, threads, progress);
    limit.keep_to_size(lumigraph);
    const DrawingEfforts efforts =
        sources.drawing_efforts(lumigraph, capture_of(lumigraph, sources.photographs));
    choose(efforts, lumigraph.drawing);
    if (lumigraph.views.size() == 1 && views_in_use > 1)
        progress.note("pack: of " + std::to_string(views_in_use) +
                      " views one is packed ([package]): nothing is blended, and from elsewhere "
                      "there is little to see");
    progress.begin("writing the package", 0);
    write_package(package_folder, lumigraph, extras);
    write_pack_record(folder, sources, package_folder);

    Json packed = Json::array();
    for (const LumigraphView& view : lumigraph.views) packed.push_back(view.name);
    const Json facts{{"views", lumigraph.views.size()},
                     {"packed", std::move(packed)},
                     {"views_in_use", views_in_use},
                     {"held_out", sources.held_out},
                     {"points", sources.photographs.capture.points.size()},
                     {"near_depth", lumigraph.near_depth},
                     {"far_depth", lumigraph.far_depth},
                     {"transients", std::move(transients)},
                     {"exposure", exposure_json(exposures.found, lumigraph)},
                     {"depth_mesh_effort", json_of(of_meshes)},
                     {"occlusion_effort", json_of(efforts.occlusion)},
                     {"depth_effort", json_of(efforts.depth)},
                     {"triangle_effort", json_of(efforts.triangles)}};
    return {json_text(facts), "{}"};
}

PackRecord read_pack_record(const fs::path& pack_folder) {
    const Json json = read_json_file(record_path(pack_folder));
    try {
        return {json.at("held_out"),
                json.at("pictures_sha256"),
                json.at("package_sha256"),
                json.value("mesh_sha256", ""),
                json.value("depth_sha256", ""),
                json.value("configuration_sha256", "")};
    } catch (const Json::exception& error) {
        refuse_json(record_path(pack_folder), error);
    }
}

}  // namespace lumi
