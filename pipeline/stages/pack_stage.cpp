#include "pipeline/stages/pack_stage.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <set>

#include "calib/capture/image_io.h"
#include "calib/work/error.h"
#include "calib/work/parallel_for.h"
#include "meshing/exposure/exposure_gains.h"
#include "meshing/surface/mesh_io.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/stages/depth_files.h"
#include "pipeline/stages/depth_range.h"
#include "pipeline/stages/file_stems.h"
#include "pipeline/stages/removed_transients.h"
#include "pipeline/stages/used_views.h"
#include "pipeline/workspace/json_file.h"
#include "render/depth_mesh/view_depth_mesh.h"
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

/// Measures how photographs differ in exposure, and notes with each view what evens it out.
ExposureGains find_exposure_gains(Lumigraph& lumigraph, int threads, Progress& progress) {
    progress.begin("comparing exposures", 0);
    const ExposureGains found =
        exposure_gains(static_cast<int>(lumigraph.views.size()),
                       exposure_ratios(pictured_views(lumigraph), threads, progress));
    if (found.model == ExposureModel::kNone) return found;
    std::vector<Eigen::Vector3d> centres_in_world;
    for (const LumigraphView& view : lumigraph.views) {
        centres_in_world.push_back(centre_in_world(view.cam_from_world));
    }
    const auto gains = gains_among_neighbours(found.gains, centres_in_world);
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        lumigraph.views[i].exposure_gain = gains[i];
    }
    return found;
}

Json exposure_json(const ExposureGains& found) {
    return {{"model", name_of(found.model)},
            {"pairs", found.pairs},
            {"difference_stops", found.difference_stops},
            {"remaining_stops", found.remaining_stops},
            {"largest_stops", found.largest_stops}};
}

/// Of the Lumigraph's views: names lead back to the capture when some were left out.
Capture capture_of(const Lumigraph& lumigraph, const PosedPhotographs& photographs) {
    std::vector<std::string> names;
    for (const LumigraphView& view : lumigraph.views) names.push_back(view.name);
    std::sort(names.begin(), names.end());
    return only_views(photographs, names).capture;
}

/// As photographs want it; where nothing can be drawn, as much as there can be.
template <typename Effort>
Effort asked(const std::function<Effort(const Lumigraph&, const Capture&)>& sufficient,
             const PackSources& sources, const Lumigraph& lumigraph, Progress& progress) {
    if (!sufficient) return {};
    try {
        return sufficient(lumigraph, capture_of(lumigraph, sources.photographs));
    } catch (const Error& error) {
        if (!error.code().starts_with("E-GL-")) throw;
        progress.note(std::string("nothing can be drawn here to see how much is enough: ") +
                      error.what());
        return {};
    }
}

/// What is done, and what photographs say to it.
template <typename Effort>
void note(const Effort& effort, Progress& progress) {
    if (const std::string text = text_of(effort); !text.empty()) progress.note("pack: " + text);
}

/// Options come before what photographs want.
DepthMeshEffort depth_mesh_effort(const PackSources& sources, const Lumigraph& lumigraph,
                                  Progress& progress) {
    if (sources.drawing.noisy_depth_error_px != 0)
        return {.noisy_error_px = sources.drawing.noisy_depth_error_px};
    const DepthMeshEffort effort =
        asked(sources.sufficient_depth_mesh_effort, sources, lumigraph, progress);
    note(effort, progress);
    return effort;
}

OcclusionEffort occlusion_effort(const PackSources& sources, const Lumigraph& lumigraph,
                                 Progress& progress) {
    if (sources.drawing.occlusion_tolerance_px != 0)
        return {.tolerance_px = sources.drawing.occlusion_tolerance_px};
    const OcclusionEffort effort =
        asked(sources.sufficient_occlusion_effort, sources, lumigraph, progress);
    note(effort, progress);
    return effort;
}

DepthEffort depth_effort(const PackSources& sources, const Lumigraph& lumigraph,
                         Progress& progress) {
    const DrawingOptions& wanted = sources.drawing;
    DepthEffort effort;
    if (wanted.depth_views == 0 || wanted.depth_block_px == 0 || !wanted.fill_holes ||
        !wanted.check_guesses)
        effort = asked(sources.sufficient_depth_effort, sources, lumigraph, progress);
    if (wanted.depth_views != 0) effort.views = wanted.depth_views;
    if (wanted.depth_block_px != 0) effort.block_px = wanted.depth_block_px;
    effort.fills_holes = wanted.fill_holes.value_or(effort.fills_holes);
    effort.checks_guesses = wanted.check_guesses.value_or(effort.checks_guesses);
    note(effort, progress);
    return effort;
}

TriangleEffort triangle_effort(const PackSources& sources, const Lumigraph& lumigraph,
                               Progress& progress) {
    const DrawingOptions& wanted = sources.drawing;
    TriangleEffort effort;
    if (wanted.triangle_error_px == 0 || !wanted.draw_thin)
        effort = asked(sources.sufficient_triangle_effort, sources, lumigraph, progress);
    if (wanted.triangle_error_px != 0) {
        effort.error_px = wanted.triangle_error_px;
        effort.loses_db = effort.triangles = 0;  // Were those of another.
    }
    effort.draws_thin = wanted.draw_thin.value_or(effort.draws_thin);
    note(effort, progress);
    return effort;
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

/// Leaves views out of a Lumigraph, always those that are missed least.
class ViewLimit {
 public:
    ViewLimit(const PackSources& sources, const fs::path& folder, int threads, Progress& progress)
        : sources_(sources), folder_(folder), threads_(threads), progress_(progress) {}

    void apply_to(Lumigraph& lumigraph) {
        const int wanted = wanted_views(lumigraph);
        if (wanted < static_cast<int>(lumigraph.views.size())) reduce(lumigraph, wanted);
        if (sources_.options.max_mib > 0) reduce_to_limit(lumigraph);
    }

 private:
    /// The views that the options ask for, before any limit of size.
    [[nodiscard]] int wanted_views(const Lumigraph& lumigraph) const {
        int wanted = static_cast<int>(lumigraph.views.size());
        if (sources_.options.fewest_views && sources_.sufficient_views) {
            wanted = sources_.sufficient_views(lumigraph, sources_.photographs.capture);
        }
        if (sources_.options.max_views > 0) wanted = std::min(wanted, sources_.options.max_views);
        return wanted;
    }

    void reduce(Lumigraph& lumigraph, int views) {
        if (names_by_worth_.empty()) rank(lumigraph);
        const std::set<std::string> kept(names_by_worth_.begin(), names_by_worth_.begin() + views);
        std::vector<int> chosen;
        for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
            if (kept.count(lumigraph.views[i].name) > 0) chosen.push_back(static_cast<int>(i));
        }
        lumigraph = lumigraph_of_views(lumigraph, capture_of(lumigraph, sources_.photographs),
                                       chosen, sources_.mesh_options);
    }

    /// Once, while all views are there.
    void rank(const Lumigraph& lumigraph) {
        std::vector<int> all(lumigraph.views.size());
        std::iota(all.begin(), all.end(), 0);
        for (const int view : views_by_worth(lumigraph, capture_of(lumigraph, sources_.photographs),
                                             all, progress_)) {
            names_by_worth_.push_back(lumigraph.views[static_cast<std::size_t>(view)].name);
        }
    }

    /// As many views as a package of the wished size holds: it is written aside and weighed until
    /// it fits.
    void reduce_to_limit(Lumigraph& lumigraph) {
        const fs::path aside = folder_ / "weighed.lumi";
        for (;;) {
            make_depth_meshes(lumigraph, threads_, progress_);
            write_package(aside, lumigraph, extras_of(sources_));
            const double mib = folder_mib(aside);
            fs::remove_all(aside);
            if (mib <= sources_.options.max_mib) return;
            const auto count = static_cast<int>(lumigraph.views.size());
            if (count <= 1) {
                throw Error(ErrorKind::kUsage, "E-PACK-MIB",
                            "[package] max_mib: not even one view fits",
                            "allow more, or make pictures smaller with [capture] max_width_px");
            }
            const auto fitting = static_cast<int>(count * sources_.options.max_mib / mib);
            reduce(lumigraph, std::clamp(fitting, 1, count - 1));
        }
    }

    const PackSources& sources_;
    fs::path folder_;
    int threads_;
    Progress& progress_;
    std::vector<std::string> names_by_worth_;
};

}  // namespace

StageEvidence run_pack_stage(const PackSources& sources, const fs::path& package_folder,
                             const fs::path& folder, int threads, Progress& progress) {
    Lumigraph lumigraph = gather_lumigraph(sources, threads, progress);
    const auto views_in_use = static_cast<int>(lumigraph.views.size());
    Json transients = Json::array();
    if (!sources.options.keep_transients) {
        transients = remove_transients(lumigraph, folder, threads, progress);
        set_depth_range(lumigraph);
    }
    lumigraph.fade_beyond_capture = sources.drawing.fade_beyond_capture;
    ExposureGains exposures;
    if (sources.drawing.even_exposure) {
        exposures = find_exposure_gains(lumigraph, threads, progress);
    }
    make_depth_meshes(lumigraph, threads, progress);
    const DepthMeshEffort of_meshes = depth_mesh_effort(sources, lumigraph, progress);
    lumigraph.noisy_depth_error_px = of_meshes.noisy_error_px;
    ViewLimit(sources, folder, threads, progress).apply_to(lumigraph);
    make_depth_meshes(lumigraph, threads, progress);
    const OcclusionEffort of_occlusion = occlusion_effort(sources, lumigraph, progress);
    lumigraph.occlusion_tolerance_px = of_occlusion.tolerance_px;
    const DepthEffort effort = depth_effort(sources, lumigraph, progress);
    lumigraph.depth_views = effort.views;
    lumigraph.depth_block_px = effort.block_px;
    lumigraph.fills_holes = effort.fills_holes;
    lumigraph.checks_guesses = effort.checks_guesses;
    const TriangleEffort of_triangles = triangle_effort(sources, lumigraph, progress);
    lumigraph.triangle_error_px = of_triangles.error_px;
    lumigraph.draws_thin = of_triangles.draws_thin;
    progress.begin("writing the package", 0);
    write_package(package_folder, lumigraph, extras_of(sources));
    write_json_file(record_path(folder),
                    Json{{"held_out", sources.held_out}, {"poses_sha256", sources.poses_sha256}});

    const Json facts{{"views", lumigraph.views.size()},
                     {"views_in_use", views_in_use},
                     {"held_out", sources.held_out},
                     {"points", sources.photographs.capture.points.size()},
                     {"near_depth", lumigraph.near_depth},
                     {"far_depth", lumigraph.far_depth},
                     {"transients", std::move(transients)},
                     {"exposure", exposure_json(exposures)},
                     {"depth_mesh_effort", json_of(of_meshes)},
                     {"occlusion_effort", json_of(of_occlusion)},
                     {"depth_effort", json_of(effort)},
                     {"triangle_effort", json_of(of_triangles)}};
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
