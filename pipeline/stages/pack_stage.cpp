#include "pipeline/stages/pack_stage.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "calib/capture/image_io.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "meshing/surface/mesh_io.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/stages/depth_files.h"
#include "pipeline/stages/depth_range.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/json_file.h"
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

Lumigraph gather_lumigraph(const PackSources& sources, int threads, Progress& progress) {
    Lumigraph lumigraph;
    lumigraph.name = sources.name;
    lumigraph.views = gather_views(sources, threads, progress);
    lumigraph.mesh = read_camera_mesh_ply(sources.mesh_folder / "camera_mesh.ply");
    validate(lumigraph.mesh, static_cast<int>(lumigraph.views.size()),
             (sources.mesh_folder / "camera_mesh.ply").string());
    const DepthRange range = depth_range_of(lumigraph.views);
    lumigraph.near_depth = range.near_depth;
    lumigraph.far_depth = range.far_depth;
    return lumigraph;
}

/// The views in use that the options ask for, before any limit of size.
int wanted_views(const Lumigraph& lumigraph, const PackSources& sources) {
    int wanted = static_cast<int>(lumigraph.views.size());
    if (sources.options.fewest_views && sources.sufficient_views) {
        wanted = sources.sufficient_views(lumigraph, sources.photographs.capture);
    }
    if (sources.options.max_views > 0) wanted = std::min(wanted, sources.options.max_views);
    return wanted;
}

Lumigraph reduced(const Lumigraph& lumigraph, const PackSources& sources, int views) {
    // Names lead back to the capture when views were left out before.
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    std::sort(names.begin(), names.end());
    const Capture capture = only_views(sources.photographs, names).capture;
    return lumigraph_of_views(lumigraph, capture, representative_views_of(capture, views),
                              sources.mesh_options);
}

PackageExtras extras_of(const PackSources& sources) {
    return {.resolved_config_toml = sources.resolved_config_toml,
            .evidence_json = sources.evidence_json,
            .points = sources.photographs.capture.points};
}

double folder_mib(const fs::path& folder) {
    std::uintmax_t bytes = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) bytes += entry.file_size();
    }
    return static_cast<double>(bytes) / (1 << 20);
}

/// The Lumigraph with as many views as a package of the wished size holds: it is written aside and
/// weighed until it fits.
void reduce_to_limit(Lumigraph& lumigraph, const PackSources& sources, const fs::path& folder) {
    const fs::path aside = folder / "weighed.lumi";
    for (;;) {
        write_package(aside, lumigraph, extras_of(sources));
        const double mib = folder_mib(aside);
        fs::remove_all(aside);
        if (mib <= sources.options.max_mib) return;
        const auto count = static_cast<int>(lumigraph.views.size());
        if (count <= 1) {
            throw Error(ErrorKind::kUsage, "E-PACK-MIB",
                        "[package] max_mib: not even one view fits",
                        "allow more, or make pictures smaller with [capture] max_width_px");
        }
        const auto fitting = static_cast<int>(count * sources.options.max_mib / mib);
        lumigraph = reduced(lumigraph, sources, std::clamp(fitting, 1, count - 1));
    }
}

}  // namespace

StageEvidence run_pack_stage(const PackSources& sources, const fs::path& package_folder,
                             const fs::path& folder, int threads, Progress& progress) {
    Lumigraph lumigraph = gather_lumigraph(sources, threads, progress);
    const auto views_in_use = static_cast<int>(lumigraph.views.size());
    const int wanted = wanted_views(lumigraph, sources);
    if (wanted < views_in_use) lumigraph = reduced(lumigraph, sources, wanted);
    progress.begin("writing the package", 0);
    if (sources.options.max_mib > 0) reduce_to_limit(lumigraph, sources, folder);
    write_package(package_folder, lumigraph, extras_of(sources));
    write_json_file(record_path(folder),
                    Json{{"held_out", sources.held_out}, {"poses_sha256", sources.poses_sha256}});

    const Json facts{
        {"views", lumigraph.views.size()},    {"views_in_use", views_in_use},
        {"held_out", sources.held_out},       {"points", sources.photographs.capture.points.size()},
        {"near_depth", lumigraph.near_depth}, {"far_depth", lumigraph.far_depth}};
    return {json_text(facts), "{}"};
}

PackRecord read_pack_record(const fs::path& pack_folder) {
    const Json json = read_json_file(record_path(pack_folder));
    try {
        return {json.at("held_out"), json.at("poses_sha256")};
    } catch (const Json::exception& error) {
        refuse_json(record_path(pack_folder), error.what());
    }
}

}  // namespace lumi
