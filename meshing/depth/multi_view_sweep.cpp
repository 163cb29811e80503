#include "meshing/depth/multi_view_sweep.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "meshing/depth/cost_volume.h"
#include "meshing/depth/semi_global_matching.h"

namespace lumi {
namespace {

constexpr int kCountUnit = 16;  // The path kernel works on this many planes at a time.
constexpr std::size_t kMaxCells = std::size_t{96} << 20;

int level_count(const Camera& camera) {
    constexpr int kMinWidth = 160;
    constexpr int kMinHeight = 100;
    int levels = 1;
    while (camera.width_px >> levels >= kMinWidth && camera.height_px >> levels >= kMinHeight) {
        ++levels;
    }
    return levels;
}

SweepView at_level(const DepthView& view, int level) {
    const GrayImage gray = gray_of(view.photograph);
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

/// Planes `spacing_px` of disparity apart over the view's range.
SweepPlanes planes_over(const DepthView& view, double level_scale, double spacing_px) {
    const double step = spacing_px / (view.disparity_px_per_inverse_depth * level_scale);
    const int needed = static_cast<int>(std::ceil((view.range.near - view.range.far) / step)) + 1;
    const int units = std::max(1, (needed + kCountUnit - 1) / kCountUnit);
    return {view.range.far, step, units * kCountUnit};
}

/// The planes of [low, high], rounded up to whole units within the sweep.
PlaneRange planes_between(double low, double high, int count) {
    const int first = std::clamp(static_cast<int>(std::floor(low)), 0, count - 1);
    const int last = std::clamp(static_cast<int>(std::ceil(high)), first, count - 1);
    const int units = (last - first + kCountUnit) / kCountUnit;
    const int spare = units * kCountUnit - (last - first + 1);
    const int begin = std::clamp(first - spare / 2, 0, count - units * kCountUnit);
    return {begin, units * kCountUnit};
}

/// Smallest and largest inverse depth that the coarser level found in and around each tile.
std::vector<InverseDepthRange> ranges_found(const FloatImage& coarse, int width, int height) {
    constexpr int kAround = 4;  // Coarse pixels.
    std::vector<InverseDepthRange> ranges;
    for (int top = 0; top < height; top += CostVolume::kTile) {
        for (int left = 0; left < width; left += CostVolume::kTile) {
            const int x_begin = std::clamp(left / 2 - kAround, 0, coarse.width() - 1);
            const int y_begin = std::clamp(top / 2 - kAround, 0, coarse.height() - 1);
            const int x_end = std::min((left + CostVolume::kTile) / 2 + kAround, coarse.width());
            const int y_end = std::min((top + CostVolume::kTile) / 2 + kAround, coarse.height());
            float low = coarse(x_begin, y_begin);
            float high = low;
            for (int y = y_begin; y < y_end; ++y) {
                const auto [least, most] =
                    std::minmax_element(coarse.row(y) + x_begin, coarse.row(y) + x_end);
                low = std::min(low, *least);
                high = std::max(high, *most);
            }
            ranges.push_back({static_cast<double>(low), static_cast<double>(high)});
        }
    }
    return ranges;
}

/// A tile's range takes in the scene points that fall into it.
void include_points(const DepthView& view, double level_scale, int width,
                    std::vector<InverseDepthRange>& ranges) {
    const int across = (width + CostVolume::kTile - 1) / CostVolume::kTile;
    for (const SparsePoint& point : view.points) {
        const int column = static_cast<int>(point.pixel.x() * level_scale) / CostVolume::kTile;
        const int row = static_cast<int>(point.pixel.y() * level_scale) / CostVolume::kTile;
        const int tile = row * across + std::min(column, across - 1);
        if (tile >= static_cast<int>(ranges.size())) continue;
        InverseDepthRange& range = ranges[static_cast<std::size_t>(tile)];
        const double inverse_depth =
            std::clamp(point.inverse_depth, view.range.far, view.range.near);
        range.far = std::min(range.far, inverse_depth);
        range.near = std::max(range.near, inverse_depth);
    }
}

std::size_t cells_of(const std::vector<PlaneRange>& ranges) {
    std::size_t cells = 0;
    for (const PlaneRange& range : ranges) {
        cells += static_cast<std::size_t>(range.count) * CostVolume::kTile * CostVolume::kTile;
    }
    return cells;
}

struct Search {
    SweepPlanes planes;
    std::vector<PlaneRange> ranges;
};

/// Where one level looks, in as fine steps as the memory allows.
Search search_of(const DepthView& view, double level_scale, double spacing_px,
                 const std::vector<InverseDepthRange>& tile_ranges) {
    constexpr double kMarginPx = 3.0;
    constexpr double kCoarser = 1.25;
    for (;; spacing_px *= kCoarser) {
        Search search{planes_over(view, level_scale, spacing_px), {}};
        const double margin = std::max(2.0, kMarginPx / spacing_px);
        for (const InverseDepthRange& range : tile_ranges) {
            search.ranges.push_back(planes_between(search.planes.plane_at(range.far) - margin,
                                                   search.planes.plane_at(range.near) + margin,
                                                   search.planes.count));
        }
        const bool is_coarsest = search.planes.count == kCountUnit;
        if (is_coarsest || cells_of(search.ranges) <= kMaxCells) return search;
    }
}

/// 255 where the contrast of the matching cost, averaged over a small window, is more than noise.
GrayImage told_apart(GrayImage contrast) {
    constexpr int kWindow = 5;
    constexpr std::uint8_t kMinContrast = 3;
    const cv::Mat source(contrast.height(), contrast.width(), CV_8U, contrast.pixels().data());
    cv::Mat mean;
    cv::blur(source, mean, cv::Size(kWindow, kWindow));
    GrayImage result(contrast.width(), contrast.height());
    std::transform(mean.begin<std::uint8_t>(), mean.end<std::uint8_t>(), result.pixels().begin(),
                   [](std::uint8_t value) {
                       return static_cast<std::uint8_t>(value >= kMinContrast ? 255 : 0);
                   });
    return result;
}

DepthMap match_level(const DepthScene& scene, const DepthView& view, int level,
                     const std::vector<InverseDepthRange>& tile_ranges) {
    const SweepView own = at_level(view, level);
    std::vector<SweepView> others;
    for (const int j : view.neighbours) {
        others.push_back(at_level(scene.views[static_cast<std::size_t>(j)], level));
    }
    const double level_scale = static_cast<double>(own.camera.width_px) / view.camera.width_px;
    Search search = search_of(view, level_scale, level == 0 ? 0.5 : 1.0, tile_ranges);
    const CostVolume volume = sweep_costs(own, others, search.planes, std::move(search.ranges));
    MatchedPlanes matched = semi_global_matching(volume, own.gray, SmoothnessPenalty{});
    for (float& plane : matched.plane.pixels()) {
        plane = static_cast<float>(search.planes.inverse_depth(static_cast<double>(plane)));
    }
    return {std::move(matched.plane), told_apart(std::move(matched.contrast))};
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

}  // namespace

DepthMap multi_view_sweep(const DepthScene& scene, int view_index) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    int level = level_count(view.camera) - 1;
    std::vector<InverseDepthRange> tile_ranges(
        static_cast<std::size_t>(
            tile_count(view.camera.width_px >> level, view.camera.height_px >> level)),
        view.range);
    DepthMap result = match_level(scene, view, level, tile_ranges);
    while (level > 0) {
        --level;
        const int width = view.camera.width_px >> level;
        const int height = view.camera.height_px >> level;
        tile_ranges = ranges_found(result.inverse_depth, width, height);
        include_points(view, static_cast<double>(width) / view.camera.width_px, width, tile_ranges);
        DepthMap finer = match_level(scene, view, level, tile_ranges);
        add_coarser(finer.confidence, result.confidence);
        result = std::move(finer);
    }
    return result;
}

}  // namespace lumi
