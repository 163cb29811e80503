#include "meshing/depth/finished_depth.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "calib/work/parallel_for.h"
#include "meshing/agreement/cross_view_check.h"
#include "meshing/agreement/depth_of_others.h"
#include "meshing/agreement/seen_past.h"
#include "meshing/agreement/surrounding_depth.h"
#include "meshing/depth_models/sparse_depth.h"
#include "meshing/filling/edge_aware_fill.h"
#include "meshing/filling/edge_snapping.h"
#include "meshing/filling/receding_fill.h"

namespace lumi {
namespace {

double one_pixel_of(const DepthView& view) {
    return view.disparity_px_per_inverse_depth > 0 ? 1.0 / view.disparity_px_per_inverse_depth
                                                   : 0.0;
}

GrayImage told_of(const GrayImage& agreed, const GrayImage& hides) {
    GrayImage told(agreed.width(), agreed.height());
    for (std::size_t i = 0; i < told.pixels().size(); ++i) {
        told.pixels()[i] = agreed.pixels()[i] != 0  ? Continuation::kAgreed
                           : hides.pixels()[i] != 0 ? Continuation::kHides
                                                    : std::uint8_t{0};
    }
    return told;
}

/// What hides something would recede into that.
void keep_what_hides(const GrayImage& told, FloatImage& distance_px) {
    for (std::size_t i = 0; i < told.pixels().size(); ++i) {
        if (told.pixels()[i] == Continuation::kHides) distance_px.pixels()[i] = 0.0F;
    }
}

/// Continues what is known over the whole map.
Continuation continued(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                       int view_index, DepthMap& map) {
    const DepthView& view = scene.views[static_cast<std::size_t>(view_index)];
    DepthOfOthers others = depth_of_others(scene, confirmed_maps, view_index);
    FloatImage distance_px = continue_known_depth(
        map, sparse_depth(view).inverse_depth, one_pixel_of(view),
        surrounding_depth(scene, confirmed_maps, view_index, others.agreed), others.hidden);
    take_claims_against(scene, confirmed_maps, view_index, std::move(others.doubtful), map,
                        distance_px);
    GrayImage told =
        told_of(others.agreed.confidence,
                continued_before_hidden(scene, confirmed_maps, view_index, map, others.hidden));
    keep_what_hides(told, distance_px);
    return {std::move(distance_px), std::move(told)};
}

/// What others agree upon is as good as what one of them has confirmed. So is what hides something
/// that others know: to look past it would be wrong.
void trust(std::uint8_t told, const GrayImage& all_told, DepthMap& map) {
    for (std::size_t i = 0; i < all_told.pixels().size(); ++i) {
        std::uint8_t& confidence = map.confidence.pixels()[i];
        if (all_told.pixels()[i] == told && confidence == kUnseen) confidence = kConfirmedByOne;
    }
}

/// Evenly over those whose depth is continued.
std::vector<int> views_to_ask(const std::vector<DepthEstimate>& estimates) {
    constexpr std::size_t kMostViews = 32;
    std::vector<int> all;
    for (std::size_t i = 0; i < estimates.size(); ++i) {
        if (!estimates[i].is_complete) all.push_back(static_cast<int>(i));
    }
    std::vector<int> asked(std::min(kMostViews, all.size()));
    for (std::size_t i = 0; i < asked.size(); ++i) asked[i] = all[i * all.size() / asked.size()];
    return asked;
}

FloatImage within(const GrayImage& mask, FloatImage distance_px) {
    for (std::size_t k = 0; k < mask.pixels().size(); ++k) {
        if (mask.pixels()[k] == 0) distance_px.pixels()[k] = 0.0F;
    }
    return distance_px;
}

}  // namespace

DepthMap confirmed_depth(const DepthScene& scene, const std::vector<DepthEstimate>& estimates,
                         int view_index) {
    constexpr double kIslandShare = 5e-4;  // Of the picture.
    const auto index = static_cast<std::size_t>(view_index);
    if (!estimates[index].needs_confirmation) return estimates[index].map;
    DepthMap map = cross_view_check(scene, estimates, view_index);
    const auto pixels = static_cast<double>(map.confidence.pixels().size());
    remove_speckles(map, 2 * one_pixel_of(scene.views[index]),
                    std::max(16, static_cast<int>(kIslandShare * pixels)));
    return map;
}

Recession fill_recession(const DepthScene& scene, const std::vector<GrayImage>& masks,
                         const std::vector<DepthEstimate>& estimates, int threads,
                         const Progress& progress, std::vector<DepthMap>& confirmed_maps) {
    const std::vector<int> asked = views_to_ask(estimates);
    Recession recession{std::nullopt, std::vector<Continuation>(estimates.size())};
    std::vector<std::vector<double>> differences(asked.size());
    const auto at_one_time = static_cast<std::size_t>(std::max(1, threads));
    for (std::size_t begin = 0; begin < asked.size(); begin += at_one_time) {
        const std::size_t count = std::min(at_one_time, asked.size() - begin);
        std::vector<FloatImage> inverse_depths(count);
        parallel_for(static_cast<int>(count), threads, [&](int i) {
            progress.throw_if_interrupted();
            const auto index = static_cast<std::size_t>(i);
            const auto view = static_cast<std::size_t>(asked[begin + index]);
            DepthMap map = confirmed_maps[view];
            Continuation& continuation = recession.continuations[view];
            continuation = continued(scene, confirmed_maps, asked[begin + index], map);
            differences[begin + index] =
                recession_differences(scene, confirmed_maps, asked[begin + index], map,
                                      within(masks[view], continuation.distance_px));
            inverse_depths[index] = std::move(map.inverse_depth);
        });
        // Not before: the views beside it read the maps, if not what is unknown in them.
        for (std::size_t i = 0; i < count; ++i) {
            confirmed_maps[static_cast<std::size_t>(asked[begin + i])].inverse_depth =
                std::move(inverse_depths[i]);
        }
    }
    recession.slope_px = chosen_recession(differences);
    return recession;
}

void fill_unknown_depth(const DepthScene& scene, const std::vector<DepthMap>& confirmed_maps,
                        int view_index, double recession_px, DepthMap& map, bool is_exact) {
    const Continuation continuation = continued(scene, confirmed_maps, view_index, map);
    finish_continued_depth(scene.views[static_cast<std::size_t>(view_index)], continuation,
                           recession_px, map, is_exact);
}

void finish_continued_depth(const DepthView& view, const Continuation& continuation,
                            double recession_px, DepthMap& map, bool is_exact) {
    const double one_pixel = one_pixel_of(view);
    const GrayImage given = is_exact ? map.confidence : GrayImage{};
    trust(Continuation::kAgreed, continuation.told, map);
    recede(recession_px, one_pixel, continuation.distance_px, map);
    smooth_filled_depth(map, view.photograph, one_pixel);
    snap_edges(map, view.photograph, one_pixel, given);
    trust(Continuation::kHides, continuation.told, map);
}

}  // namespace lumi
