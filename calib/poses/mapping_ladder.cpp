#include "calib/poses/mapping_ladder.h"

#include <algorithm>
#include <array>

#include "calib/capture/colmap_model.h"
#include "calib/poses/colmap_front_end.h"
#include "calib/poses/registration.h"
#include "calib/poses/verified_matching.h"
#include "calib/work/error.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;

struct Rung {
    const char* name;
    const char* description;
    MapperSettings settings = {};
    bool more_features = false;
    double until_share = 1.0;  ///< Tried only while fewer photographs than this are placed.
};

constexpr MapperSettings kLenientSettings{.init_min_triangulation_angle_deg = 4,
                                          .init_min_inliers = 40,
                                          .add_min_inliers = 15,
                                          .add_min_inlier_share = 0.15};

/// Never below 4 degrees: at 2 the mapper was seen to try starting pairs without end.
const std::array<Rung, 4> kLadder{{
    {.name = "default", .description = "COLMAP's own start"},
    {.name = "gentle",
     .description = "gentler start (init_min_tri_angle 4, init_min_num_inliers 40)",
     .settings = {.init_min_triangulation_angle_deg = 4, .init_min_inliers = 40},
     .until_share = 0.9},
    {.name = "lenient",
     .description = "gentler start, fewer matches to add a photograph",
     .settings = kLenientSettings,
     .until_share = 0.8},
    {.name = "detailed",
     .description = "more features, gentler start, fewer matches to add a photograph",
     .settings = kLenientSettings,
     .more_features = true,
     .until_share = 0.8},
}};

std::vector<fs::path> model_folders(const fs::path& models) {
    std::vector<fs::path> folders;
    for (int number = 0; fs::is_directory(models / std::to_string(number)); ++number) {
        folders.push_back(models / std::to_string(number));
    }
    return folders;
}

void restore_names(Capture& capture, const std::vector<Photograph>& photographs,
                   const fs::path& folder) {
    for (View& view : capture.views) {
        const std::optional<int> index = photograph_index_of(view.name);
        if (!index || static_cast<std::size_t>(*index) >= photographs.size()) {
            throw Error(ErrorKind::kExternalProgram, "E-COLMAP-MODEL",
                        folder.string() + ": names a photograph that was not given: " + view.name,
                        "run the same command again");
        }
        view.name = photographs[static_cast<std::size_t>(*index)].name;
    }
}

bool is_better(const Capture& a, const Capture& b) {
    if (a.views.size() != b.views.size()) return a.views.size() > b.views.size();
    return a.points.size() > b.points.size();
}

/// A run that had to be ended may have finished a model before, and may have left half of another.
std::optional<BestModel> model_of(const ColmapRun& run, const fs::path& models,
                                  const std::vector<Photograph>& photographs) {
    if (run.result.end == ChildEnd::kExited) return read_best_model(models, photographs);
    try {
        return read_best_model(models, photographs);
    } catch (const Error&) {
        return std::nullopt;
    }
}

/// What COLMAP's mapper reads, from what was matched by ourselves.
void write_database(const MappingJob& job, MatchedPhotographs& matched) {
    if (!matched.database.empty()) return;
    matched.database = job.scratch_folder / (matched.name + ".db");
    record(job.evidence, create_colmap_database(colmap_of(job), matched.database, job.progress));
    fill_colmap_database(matched.database, job.groups.cameras, matched.photographs);
    write_verified_pairs(matched.database, matched.pairs);
}

}  // namespace

std::optional<BestModel> read_best_model(const fs::path& models,
                                         const std::vector<Photograph>& photographs) {
    std::optional<BestModel> best;
    int found = 0;
    for (const fs::path& folder : model_folders(models)) {
        Capture capture = read_colmap_model(folder);
        ++found;
        if (capture.views.size() < 2 || capture.points.empty()) continue;
        restore_names(capture, photographs, folder);
        drop_unused_cameras(capture);  // COLMAP writes every camera of its database.
        if (!best || is_better(capture, best->capture)) best = BestModel{std::move(capture), 0};
    }
    if (best) best->models_found = found;
    return best;
}

std::optional<Capture> map_by_ladder(const MappingJob& job, MatchedPhotographs& matched) {
    const std::size_t total = job.photographs.size();
    std::optional<Capture> best;
    std::string ended;
    for (const Rung& rung : kLadder) {
        const std::size_t placed = best ? best->views.size() : 0;
        if (best && static_cast<double>(placed) >= rung.until_share * static_cast<double>(total)) {
            break;
        }
        std::optional<MatchedPhotographs> detailed;
        if (rung.more_features) {
            detailed = match_more_features(job, matched, placed, rung.name);
            if (!detailed) break;
        }
        MatchedPhotographs& mapped_from = detailed ? *detailed : matched;
        write_database(job, mapped_from);
        const fs::path models = job.scratch_folder / ("models_" + std::string(rung.name));
        fs::create_directories(models);
        MapperSettings settings = rung.settings;
        settings.refine_lens = job.refine_lens;
        job.progress.begin(std::string("placing photographs: ") + rung.description, total);
        const ColmapRun run = map_with_colmap(
            colmap_of(job), mapped_from.database, models, settings,
            "mapper_" + std::string(rung.name),
            [&](int count) { job.progress.advance(static_cast<std::size_t>(count)); },
            job.progress);
        record(job.evidence, run);
        if (run.result.end != ChildEnd::kExited) ended = run.ending;
        std::optional<BestModel> model = model_of(run, models, job.photographs);
        if (!model || (best && !is_better(model->capture, *best))) continue;
        best = std::move(model->capture);
        if (detailed) matched = std::move(*detailed);
        job.evidence.models_found = model->models_found;
        job.evidence.start = rung.description;
    }
    if (!best && !ended.empty()) {
        throw Error(ErrorKind::kExternalProgram, "E-COLMAP-TIME",
                    job.options.colmap + " mapper: " + ended + ", and no model was made",
                    "raise [poses] time_limit_s, or use fewer or smaller photographs");
    }
    return best;
}

}  // namespace lumi
