#include "pipeline/depth_bench/rung_measurement.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numeric>
#include <sstream>

#include "calib/capture/all_views.h"
#include "calib/pictures/image_io.h"
#include "calib/work/error.h"
#include "calib/work/median.h"
#include "calib/work/parallel_for.h"
#include "calib/work/process_memory.h"
#include "meshing/depth_models/imported_depth.h"
#include "meshing/depth_scene/depth_scene.h"
#include "pipeline/depth_bench/right_shares.h"
#include "pipeline/evaluate/depth_effort.h"
#include "pipeline/stages/depth_range.h"
#include "pipeline/stages/used_views.h"
#include "render/depth_mesh/view_depth_mesh.h"

namespace lumi {
namespace {

Lumigraph lumigraph_of(const DepthBenchScene& scene, std::vector<DepthMap> depth_maps,
                       int threads) {
    const Capture& capture = scene.used.capture;
    Lumigraph lumigraph;
    lumigraph.name = scene.name;
    lumigraph.mesh = scene.mesh;
    lumigraph.views.resize(capture.views.size());
    parallel_for(static_cast<int>(capture.views.size()), threads, [&](int i) {
        const auto index = static_cast<std::size_t>(i);
        const View& view = capture.views[index];
        lumigraph.views[index] = {view.name,
                                  camera_of(capture, view),
                                  view.cam_from_world,
                                  1,
                                  read_color_image(scene.used.picture_paths[index]),
                                  std::move(depth_maps[index])};
    });
    const DepthRange range = depth_range_of(lumigraph.views);
    lumigraph.near_depth = range.near_depth;
    lumigraph.far_depth = range.far_depth;
    return lumigraph;
}

int sufficient_depth_views(const Lumigraph& lumigraph, const DepthBenchScene& scene,
                           Progress& progress) {
    KeptBackPhotographs kept_back(lumigraph, scene.used.capture, {}, progress);
    return sufficient_depth_effort(kept_back, lumigraph.drawing).views;
}

/// Mean squared errors of tiles, over what was drawn.
class TileErrors {
 public:
    void add(const JudgedView& view) {
        constexpr int kTile = 64;
        const ColorImage& photograph = view.photograph;
        for (int top = 0; top < photograph.height(); top += kTile) {
            for (int left = 0; left < photograph.width(); left += kTile) {
                add_tile(view, left, top, std::min(left + kTile, photograph.width()),
                         std::min(top + kTile, photograph.height()));
            }
        }
    }
    [[nodiscard]] double mean() const {
        return std::accumulate(errors_.begin(), errors_.end(), 0.0) /
               std::max<double>(1, static_cast<double>(errors_.size()));
    }
    [[nodiscard]] double standard_error() const {
        if (errors_.size() < 2) return 0;
        const double middle = mean();
        double sum = 0;
        for (const double error : errors_) sum += (error - middle) * (error - middle);
        const auto count = static_cast<double>(errors_.size());
        return std::sqrt(sum / (count * (count - 1)));
    }

 private:
    void add_tile(const JudgedView& view, int left, int top, int right, int bottom) {
        double sum = 0;
        int count = 0;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) {
                if (view.rendering.coverage(x, y) == 0) continue;
                const Rgb8& a = view.photograph(x, y);
                const Rgb8& b = view.rendering.color(x, y);
                for (const int difference : {a.r - b.r, a.g - b.g, a.b - b.b}) {
                    sum += difference * difference;
                }
                count += 3;
            }
        }
        if (count > 0) errors_.push_back(sum / count);
    }
    std::vector<double> errors_;
};

/// Throws where the truth is measured in another unit than the workspace: all would be wrong.
void require_one_unit(const DepthScene& scene, const std::vector<DepthMap>& truth,
                      const std::filesystem::path& folder) {
    constexpr double kFartherApart = 1.1;
    const auto ratio = points_by_truth(scene, truth);
    if (!ratio || (*ratio < kFartherApart && 1 / *ratio < kFartherApart)) return;
    std::ostringstream says;
    says << "exact depth in " << folder.string() << " is " << std::setprecision(3) << *ratio
         << " times the distance at which the workspace has its scene points: its poses are in "
            "another unit, or of another scene";
    throw Error(ErrorKind::kBadInput, "E-BENCH-TRUTH-UNIT", says.str(),
                "build the workspace from the poses that the depth belongs to, with [capture] "
                "import");
}

void take_truth(const DepthBenchScene& scene, const DepthOptions& options,
                const std::vector<DepthMap>& depth_maps, int threads, Progress& progress,
                RungMeasurement& measured) {
    const DepthScene depth_scene = make_depth_scene(
        scene.used, all_views(scene.used.capture),
        {.max_width_px = options.max_width_px, .max_neighbours = options.max_neighbours}, threads,
        progress);
    std::vector<DepthMap> truth;
    for (std::size_t i = 0; i < scene.truth_files.size(); ++i)
        truth.push_back(imported_depth(depth_scene.views[i], scene.truth_files[i]));
    require_one_unit(depth_scene, truth, scene.truth_folder);
    const RightShares shares = right_shares(depth_scene, truth, depth_maps);
    measured.right_share = shares.of_confident;
    measured.right_visible_share = shares.of_visible;
}

void take_evidence(const DepthResult& result, RungMeasurement& measured) {
    measured.choice = result.choice;
    measured.expected_peak_mib = static_cast<double>(result.memory.peak()) / (1 << 20);
    double cpu_s = result.choice_cpu_s;
    double megapixels = 0;
    std::vector<double> residuals;
    for (std::size_t i = 0; i < result.evidence.size(); ++i) {
        cpu_s += result.evidence[i].cpu_s;
        megapixels += 1e-6 * static_cast<double>(result.depth_maps[i].confidence.pixels().size());
        residuals.push_back(result.evidence[i].sparse_residual_px);
        measured.confident_share +=
            result.evidence[i].confident_share / static_cast<double>(result.evidence.size());
    }
    measured.cpu_s_per_megapixel = megapixels > 0 ? cpu_s / megapixels : 0;
    measured.sparse_residual_px = median_of(std::move(residuals));
}

}  // namespace

RungMeasurement measure_rung(const DepthBenchScene& scene, const DepthOptions& options, int threads,
                             const JudgedViewSink& keep, Progress& progress) {
    RungMeasurement measured;
    measured.scene = scene.name;
    measured.model = options.model;
    release_free_memory();
    const bool tells_memory = forget_peak_memory();
    DepthResult result =
        estimate_depth(scene.used, all_views(scene.used.capture), options, threads, progress);
    if (const auto peak = peak_memory(); peak && tells_memory) {
        measured.peak_mib = static_cast<double>(*peak) / (1 << 20);
    }
    take_evidence(result, measured);
    if (!scene.truth_files.empty()) {
        take_truth(scene, options, result.depth_maps, threads, progress, measured);
    }
    Lumigraph lumigraph = lumigraph_of(scene, std::move(result.depth_maps), threads);
    make_depth_meshes(lumigraph, threads, progress);
    lumigraph.drawing.depth_views = sufficient_depth_views(lumigraph, scene, progress);
    TileErrors tiles;
    const Evaluation evaluation = evaluate_held_out(
        lumigraph, scene.held_out,
        {.modes = {RenderMode::kPerPixel}, .ghost_energy = false, .timed_frames = 1},
        [&](RenderMode mode, const JudgedView& view) {
            tiles.add(view);
            keep(mode, view);
        },
        progress);
    measured.held_out = mean_score(evaluation.modes.front().views);
    measured.rms_error = std::sqrt(tiles.mean());
    // Of a root: half the relative error of its square.
    measured.rms_standard_error =
        measured.rms_error > 0 ? tiles.standard_error() / (2 * measured.rms_error) : 0;
    return measured;
}

}  // namespace lumi
