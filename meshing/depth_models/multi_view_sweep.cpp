#include "meshing/depth_models/multi_view_sweep.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "calib/capture/gray.h"
#include "meshing/depth_models/sparse_depth.h"
#include "meshing/matching/cost_volume.h"
#include "meshing/matching/semi_global_matching.h"
#include "meshing/matching/sweep_search.h"
#include "meshing/matching/tile_search.h"

namespace lumi {
namespace {

int level_count(const Camera& camera) {
    constexpr int kMinWidth = 120;
    constexpr int kMinHeight = 80;
    int levels = 1;
    while (camera.width_px >> levels >= kMinWidth && camera.height_px >> levels >= kMinHeight) {
        ++levels;
    }
    return levels;
}

/// A view in grey, at full size.
struct GrayView {
    const DepthView* view;
    GrayImage gray;
};

/// What one sweep compares.
struct Compared {
    GrayView own;
    std::vector<GrayView> others;
};

Compared compared_in(const DepthScene& scene, const DepthView& view) {
    Compared compared{{&view, gray_of(view.photograph)}, {}};
    for (const int j : view.neighbours) {
        const DepthView& other = scene.views[static_cast<std::size_t>(j)];
        compared.others.push_back({&other, gray_of(other.photograph)});
    }
    return compared;
}

SweepView at_level(const GrayView& full, int level) {
    const DepthView& view = *full.view;
    const GrayImage& gray = full.gray;
    if (level == 0) return {view.camera, view.cam_from_world, gray};
    const int width = gray.width() >> level;
    const int height = gray.height() >> level;
    GrayImage small(width, height);
    const cv::Mat source(gray.height(), gray.width(), CV_8U,
                         const_cast<std::uint8_t*>(gray.pixels().data()));
    cv::Mat target(height, width, CV_8U, small.pixels().data());
    cv::resize(source, target, target.size(), 0, 0, cv::INTER_AREA);
    return {resized(view.camera, width, height), view.cam_from_world, std::move(small)};
}

/// kKnown where the chosen planes fit, and better than the others do by more than noise; both on
/// average over a small window.
GrayImage told_apart(const GrayImage& mean_costs, const GrayImage& chosen_costs) {
    constexpr int kWindow = 5;
    constexpr std::uint8_t kMinContrast = 3;
    // Unrelated pictures differ in as many census bits even at the best of a dozen planes.
    constexpr std::uint8_t kMaxCost = 18;
    cv::Mat contrast(mean_costs.height(), mean_costs.width(), CV_8U);
    std::transform(mean_costs.pixels().begin(), mean_costs.pixels().end(),
                   chosen_costs.pixels().begin(), contrast.begin<std::uint8_t>(),
                   [](std::uint8_t mean, std::uint8_t chosen) {
                       return static_cast<std::uint8_t>(std::max(0, mean - chosen));
                   });
    cv::blur(contrast, contrast, cv::Size(kWindow, kWindow));
    GrayImage chosen = chosen_costs;
    cv::Mat cost(chosen.height(), chosen.width(), CV_8U, chosen.pixels().data());
    cv::blur(cost, cost, cv::Size(kWindow, kWindow));
    GrayImage result(mean_costs.width(), mean_costs.height());
    std::transform(contrast.begin<std::uint8_t>(), contrast.end<std::uint8_t>(),
                   chosen.pixels().begin(), result.pixels().begin(),
                   [](std::uint8_t better, std::uint8_t mismatch) {
                       const bool is_told = better >= kMinContrast && mismatch <= kMaxCost;
                       return is_told ? kKnown : kUnseen;
                   });
    return result;
}

/// `coarser`: what the level before found; of the coarsest, nothing.
DepthMap match_level(const Compared& compared, int level, const std::vector<TileSurface>& surfaces,
                     const DepthMap& coarser, SweepMemory& memory) {
    const DepthView& view = *compared.own.view;
    const SweepView own = at_level(compared.own, level);
    std::vector<SweepView> others;
    for (const GrayView& other : compared.others) others.push_back(at_level(other, level));
    const double level_scale = static_cast<double>(own.camera.width_px) / view.camera.width_px;
    const bool has_coarser = !coarser.confidence.empty();
    SweepSearch search =
        sweep_search(view, level_scale, level == 0 ? 0.75 : 1.0, surfaces, has_coarser);
    CostVolume volume =
        sweep_costs(own, others, search.planes, std::move(search.tiles), std::move(memory.costs));
    MatchedPlanes matched =
        semi_global_matching(volume, own.gray, SmoothnessPenalty{}, memory.sums);
    memory.costs = std::move(volume.costs());
    for (float& plane : matched.plane.pixels()) {
        const double inverse_depth = search.planes.inverse_depth(static_cast<double>(plane));
        plane = static_cast<float>(std::max(0.0, inverse_depth));
    }
    DepthMap found{std::move(matched.plane), told_apart(volume.mean_seen_costs(), matched.cost)};
    if (search.keeps_coarser) keep_beyond_planes(volume, search.planes, coarser, found);
    return found;
}

/// A smooth texture tells little on the finest level, whose ranges are narrow, but much on a
/// coarser one: what any level could tell is told.
void add_coarser(GrayImage& told, const GrayImage& coarse) {
    for (int y = 0; y < told.height(); ++y) {
        const int coarse_y = std::min(y / 2, coarse.height() - 1);
        for (int x = 0; x < told.width(); ++x) {
            told(x, y) |= coarse(std::min(x / 2, coarse.width() - 1), coarse_y);
        }
    }
}

/// What the coarsest level takes the slopes of its planes from; empty without enough points.
FloatImage slope_guide(const DepthView& view) {
    constexpr std::size_t kMinPoints = 50;
    if (view.points.size() < kMinPoints) return {};
    return sparse_depth(view).inverse_depth;
}

double one_pixel_at(const DepthView& view, double level_scale) {
    return 1.0 / (view.disparity_px_per_inverse_depth * level_scale);
}

/// The whole range, first along the slopes that the points suggest, then along those it found: a
/// floor comes out in shreds first, which lie on the floor's plane all the same.
DepthMap match_coarsest(const Compared& compared, int level, SweepMemory& memory) {
    constexpr int kRounds = 2;
    constexpr double kFollowPx = 5.0;
    const DepthView& view = *compared.own.view;
    const int width = view.camera.width_px >> level;
    const int height = view.camera.height_px >> level;
    const double one_pixel = one_pixel_at(view, static_cast<double>(width) / view.camera.width_px);
    DepthMap found =
        match_level(compared, level,
                    search_whole_range(view.range, width, height, slope_guide(view)), {}, memory);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<TileSurface> surfaces =
            search_around(found.inverse_depth, width, height, kFollowPx * one_pixel);
        for (TileSurface& surface : surfaces) surface.at_centre = surface.core = view.range;
        found = match_level(compared, level, surfaces, {}, memory);
    }
    return found;
}

/// One level finer, around what the coarser level found.
DepthMap match_finer(const Compared& compared, int level, const DepthMap& coarser,
                     SweepMemory& memory) {
    constexpr double kFollowPx = 2.0;
    const DepthView& view = *compared.own.view;
    const int width = view.camera.width_px >> level;
    const int height = view.camera.height_px >> level;
    const double scale = static_cast<double>(width) / view.camera.width_px;
    std::vector<TileSurface> surfaces =
        search_around(coarser.inverse_depth, width, height, kFollowPx * one_pixel_at(view, scale));
    include_points(view, scale, width, surfaces);
    DepthMap finer = match_level(compared, level, surfaces, coarser, memory);
    add_coarser(finer.confidence, coarser.confidence);
    return finer;
}

}  // namespace

SweepMemory SweepMemoryPool::take() {
    const std::lock_guard lock(mutex_);
    if (spare_.empty()) return {};
    SweepMemory memory = std::move(spare_.back());
    spare_.pop_back();
    return memory;
}

void SweepMemoryPool::give_back(SweepMemory memory) {
    const std::lock_guard lock(mutex_);
    spare_.push_back(std::move(memory));
}

DepthMap multi_view_sweep(const DepthScene& scene, int view_index, SweepMemory& memory) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    const Compared compared = compared_in(scene, view);
    const int coarsest = level_count(view.camera) - 1;
    DepthMap found = match_coarsest(compared, coarsest, memory);
    for (int level = coarsest - 1; level >= 0; --level) {
        found = match_finer(compared, level, found, memory);
    }
    return found;
}

}  // namespace lumi
