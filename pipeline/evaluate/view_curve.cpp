#include "pipeline/evaluate/view_curve.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "calib/pictures/image_io.h"
#include "calib/work/mean.h"
#include "calib/work/median.h"
#include "calib/work/stopwatch.h"
#include "pipeline/evaluate/pictured_eye.h"
#include "pipeline/stages/chosen_views.h"
#include "pipeline/synth/hashed_random.h"
#include "render/lumigraph/even_exposure.h"

namespace lumi {
namespace {

constexpr double kTolerableLoss_db = 0.3;
/// Share of the views to which the fewest that are enough are looked for.
constexpr double kFineShare = 0.05;
constexpr int kLeastToChooseFrom = 12;
constexpr int kValidateEvery = 6;

/// Draws held-out pictures from chosen views.
class ChoiceJudge {
 public:
    ChoiceJudge(const Lumigraph& lumigraph, const Capture& capture,
                std::vector<PicturedEye> pictures, const CameraMeshOptions& mesh_options)
        : lumigraph_(lumigraph),
          capture_(capture),
          pictures_(std::move(pictures)),
          mesh_options_(mesh_options) {}

    /// Minus the PSNR in dB at each held-out place.
    [[nodiscard]] std::vector<double> losses_of(const std::vector<int>& views) {
        DrawnPictures drawn = draw_pictures(
            lumigraph_of_views(lumigraph_, capture_, views, mesh_options_), pictures_);
        last_ms_ = median_of(std::move(drawn.frame_ms));
        return std::move(drawn.losses_db);
    }
    [[nodiscard]] double last_ms() const { return last_ms_; }

 private:
    const Lumigraph& lumigraph_;
    const Capture& capture_;
    std::vector<PicturedEye> pictures_;
    CameraMeshOptions mesh_options_;
    double last_ms_ = 0.0;
};

std::vector<int> all_of(std::size_t count) {
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    return all;
}

std::vector<int> random_views(std::size_t count, std::size_t wanted, HashedRandom& random) {
    std::vector<int> views = all_of(count);
    for (std::size_t i = 0; i < wanted; ++i) {
        std::swap(views[i], views[i + random.below(count - i)]);
    }
    views.resize(wanted);
    std::sort(views.begin(), views.end());
    return views;
}

void draw_random_choices(ViewCurvePoint& point, std::size_t all_views,
                         const ViewCurveOptions& options, ChoiceJudge& judge) {
    HashedRandom random(options.seed, static_cast<std::uint64_t>(point.views));
    double squares = 0;
    for (int i = 0; i < options.random_choices; ++i) {
        const double psnr = -mean_of(judge.losses_of(
            random_views(all_views, static_cast<std::size_t>(point.views), random)));
        point.random_psnr_db += psnr / options.random_choices;
        squares += psnr * psnr / options.random_choices;
        point.best_random_psnr_db = std::max(point.best_random_psnr_db, psnr);
    }
    const double mean = point.random_psnr_db;
    point.random_deviation_db = std::sqrt(std::max(0.0, squares - mean * mean));
}

std::vector<int> sizes_to_try(int all_views, const ViewCurveOptions& options) {
    if (options.sizes.empty()) return selection_sizes(all_views, options.least_views);
    std::vector<int> sizes = options.sizes;
    std::erase(sizes, all_views);
    sizes.push_back(all_views);
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes;
}

/// The fewest views that lose little against the best number.
int fewest_tolerable(const std::vector<ViewCurvePoint>& points) {
    double best_db = points.front().psnr_db;
    for (const ViewCurvePoint& point : points) best_db = std::max(best_db, point.psnr_db);
    int fewest = points.front().views;
    for (const ViewCurvePoint& point : points) {
        if (point.psnr_db >= best_db - kTolerableLoss_db) fewest = std::min(fewest, point.views);
    }
    return fewest;
}

/// The greatest number below `views` that was tried; `views` when there is none.
int next_fewer(const std::vector<ViewCurvePoint>& points, int views) {
    int next = 0;
    for (const ViewCurvePoint& point : points) {
        if (point.views < views) next = std::max(next, point.views);
    }
    return next > 0 ? next : views;
}

}  // namespace

ViewCurve measure_view_curve(const Lumigraph& lumigraph, const Capture& capture,
                             const PosedPhotographs& held_out, const ViewCurveOptions& options,
                             int threads, Progress& progress) {
    std::vector<PicturedEye> pictures;
    for (std::size_t i = 0; i < held_out.capture.views.size(); ++i) {
        const View& view = held_out.capture.views[i];
        const Camera& camera = camera_of(held_out.capture, view);
        pictures.push_back({{camera, view.cam_from_world},
                            read_color_image(held_out.picture_paths[i]),
                            lumigraph.evened_falloff});
    }
    ChoiceJudge judge(lumigraph, capture, std::move(pictures), options.mesh);
    const std::size_t all_views = lumigraph.views.size();
    const std::vector<int> sizes = sizes_to_try(static_cast<int>(all_views), options);
    ViewCurve curve;
    const Stopwatch stopwatch;
    const std::vector<int> by_worth =
        views_by_worth(lumigraph, capture, all_of(all_views), threads, progress);
    curve.ranking_cpu_s = stopwatch.elapsed().cpu_s;
    const auto measure = [&](const std::vector<int>& views) {
        progress.throw_if_interrupted();
        std::vector<double> losses = judge.losses_of(views);
        curve.points.push_back({static_cast<int>(views.size()), -mean_of(losses),
                                texture_mib(lumigraph, views), judge.last_ms(), 0.0, 0.0});
        if (views.size() < all_views) {
            draw_random_choices(curve.points.back(), all_views, options, judge);
        }
        progress.advance();
        return losses;
    };
    progress.begin("drawing from ever fewer views", sizes.size());
    const ViewSelection selection = select_views(by_worth, sizes, measure);
    curve.auto_views = static_cast<int>(selection.curve[selection.chosen].views.size());
    curve.third_db_views = fewest_tolerable(curve.points);
    while (options.sizes.empty()) {
        const int next = next_fewer(curve.points, curve.third_db_views);
        if (curve.third_db_views - next <= std::max(1.0, kFineShare * curve.third_db_views)) break;
        measure(most_worthy_views(by_worth, (next + curve.third_db_views) / 2));
        std::sort(curve.points.begin(), curve.points.end(),
                  [](const auto& a, const auto& b) { return a.views > b.views; });
        curve.third_db_views = fewest_tolerable(curve.points);
    }
    return curve;
}

int sufficient_views(const Lumigraph& lumigraph, const Capture& capture,
                     const CameraMeshOptions& mesh_options, int threads, Progress& progress) {
    const auto count = static_cast<int>(lumigraph.views.size());
    if (count < kLeastToChooseFrom) return count;
    Lumigraph evened = lumigraph;
    even_exposures(evened);
    const int every = std::min(kValidateEvery, count / 3);
    KeptBackViews kept = keep_back(evened, every, every / 2);
    const std::vector<int> candidates = std::move(kept.others);
    ChoiceJudge judge(evened, capture, std::move(kept.pictures), mesh_options);
    const std::vector<int> sizes = selection_sizes(static_cast<int>(candidates.size()), 4);
    progress.begin("looking for the fewest views", sizes.size());
    const ViewSelection selection =
        select_views(views_by_worth(evened, capture, candidates, threads, progress), sizes,
                     [&](const std::vector<int>& views) {
                         progress.throw_if_interrupted();
                         progress.advance();
                         return judge.losses_of(views);
                     });
    const double share = static_cast<double>(selection.curve[selection.chosen].views.size()) /
                         static_cast<double>(candidates.size());
    return static_cast<int>(std::ceil(share * count));
}

}  // namespace lumi
