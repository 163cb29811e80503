#include "render/depth_search/depth_search.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/depth_search/occlusion.h"
#include "render/faces/shell_opacity.h"
#include "render/transfer/past_sight.h"

namespace lumi {
namespace {

/// Vertices just outside of a photograph, where a picture ends that is the photograph, still count.
constexpr double kBorderSlack_px = 1.0;
/// What is this share as near as the scene's near end is infinitely far.
constexpr double kFarShare = 1e-4;

}  // namespace

DepthSearch::DepthSearch(const Lumigraph& lumigraph, const SearchedViews& views, const Eye& eye)
    : occlusion_tolerance_px_(lumigraph.drawing.occlusion_tolerance_px),
      least_inverse_depth_(kFarShare * scene_inverse_depths(lumigraph).near),
      has_depth_(lumigraph.has_depth()) {
    std::vector<int> all(lumigraph.views.size());
    std::iota(all.begin(), all.end(), 0);
    agreeing_inverse_depth_ =
        agreeing_inverse_depth(lumigraph, views.geometries, all,
                               centre_in_world(eye.cam_from_world), kAgreeingDisparity_px);
    const double nearest = nearest_inverse_depth(lumigraph);
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        views_.emplace_back(lumigraph.views[i], views.depths[i], views.geometries[i], eye, nearest);
        sees_thin_.push_back(!views.thin[i].indices.empty());
        has_thin_ = has_thin_ || sees_thin_.back();
    }
}

std::optional<RayHit> DepthSearch::first_hit_in(int view_index,
                                                const Eigen::Vector2d& pixel) const {
    const std::optional<ViewHit> hit = view(view_index).first_hit(pixel);
    if (!hit) return std::nullopt;
    return RayHit{hit->inverse_depth, hit->kind, 1, {view_index, kNoView, kNoView}};
}

std::optional<RayHit> DepthSearch::first_hit(const Eigen::Vector2d& pixel,
                                             const std::array<int, 3>& view_indices) const {
    std::array<std::optional<RayHit>, 3> hits;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto here = view_indices.begin() + static_cast<std::ptrdiff_t>(k);
        if (std::find(view_indices.begin(), here, *here) == here)
            hits[k] = first_hit_in(*here, pixel);
        if (k == 1 && hits[0] && hits[1] && hits[0]->kind == DepthKind::kSeen &&
            hits[1]->kind == DepthKind::kSeen &&
            std::abs(hits[0]->inverse_depth - hits[1]->inverse_depth) <= agreeing_inverse_depth_)
            break;
    }
    if (const std::optional<RayHit> seen = nearest_seen(hits)) {
        const std::optional<RayHit> before = lone_hit_before(*seen, pixel, hits);
        return before ? before : seen;
    }
    const auto guess =
        std::find_if(hits.begin(), hits.end(), [](const auto& hit) { return hit.has_value(); });
    return guess == hits.end() ? std::nullopt : *guess;
}

std::optional<RayHit> DepthSearch::nearest_seen(
    const std::array<std::optional<RayHit>, 3>& hits) const {
    std::optional<RayHit> chosen;
    for (const auto& candidate : hits) {
        if (!candidate || candidate->kind != DepthKind::kSeen) continue;
        RayHit merged;
        for (const auto& other : hits) {
            if (!other || other->kind != DepthKind::kSeen ||
                std::abs(other->inverse_depth - candidate->inverse_depth) > agreeing_inverse_depth_)
                continue;
            merged.inverse_depth += other->inverse_depth;
            merged.views[static_cast<std::size_t>(merged.support)] = other->views[0];
            ++merged.support;
        }
        merged.inverse_depth /= merged.support;
        const int support = std::min(2, merged.support);
        const int chosen_support = chosen ? std::min(2, chosen->support) : 0;
        if (support > chosen_support ||
            (support == chosen_support && merged.inverse_depth > chosen->inverse_depth))
            chosen = merged;
    }
    return chosen;
}

std::optional<RayHit> DepthSearch::lone_hit_before(
    const RayHit& agreed, const Eigen::Vector2d& pixel,
    const std::array<std::optional<RayHit>, 3>& hits) const {
    if (agreed.support < 2) return std::nullopt;
    // Of three hits there is one at most beside two that agree.
    const auto lone = std::find_if(hits.begin(), hits.end(), [&](const auto& hit) {
        return hit && hit->kind == DepthKind::kSeen && is_before(*hit, agreed);
    });
    if (lone == hits.end()) return std::nullopt;
    const auto end = agreed.views.begin() + agreed.support;
    const double nearest_seen =
        nearest_seen_past_for(agreed.inverse_depth, agreeing_inverse_depth_);
    const bool is_imagined = std::any_of(agreed.views.begin(), end, [&](int view_index) {
        return looks_past(pixel, (*lone)->inverse_depth, nearest_seen, view_index);
    });
    return is_imagined ? std::nullopt : *lone;
}

bool DepthSearch::looks_past(const Eigen::Vector2d& pixel, double inverse_depth,
                             double nearest_seen, int view_index) const {
    const ViewSearch& asked = view(view_index);
    const auto at = asked.line_of(pixel).at(inverse_depth);
    if (!at || asked.to_border_px(at->pixel) < 0) return false;
    const double seen = at->depth_ratio * asked.surface_at(at->pixel).inverse_depth;
    return inverse_depth - seen > agreeing_inverse_depth_ && seen <= nearest_seen;
}

double DepthSearch::inside(int view_index, const Eigen::Vector2d& view_pixel) const {
    return border_fade(kBorderSlack_px + view(view_index).to_border_px(view_pixel));
}

double DepthSearch::inner_share_of(int view_index, const Eigen::Vector2d& view_pixel) const {
    const ViewSearch& seen_by = view(view_index);
    return inner_share(seen_by.to_border_px(view_pixel), seen_by.smaller_side_px());
}

double DepthSearch::hidden_by_px(const Eigen::Vector2d& pixel, double inverse_depth,
                                 int view_index) const {
    const ViewSearch& seen_by = view(view_index);
    const auto at = seen_by.line_of(pixel).at(inverse_depth);
    if (!at || seen_by.depth().empty() || inside(view_index, at->pixel) <= 0) return 0;
    const SeenSurface surface = seen_by.surface_at(at->pixel);
    if (surface.kind != DepthKind::kSeen) return 0;
    return std::max(0.0, surface.inverse_depth - at->inverse_depth) * seen_by.disparity_px();
}

bool DepthSearch::is_part_hidden(const Footprint& corners, double least_px, int view_index) const {
    if (!sees_thin_[static_cast<std::size_t>(view_index)]) return false;
    const ViewSearch& seen_by = view(view_index);
    Footprint in_depth = corners;
    for (Eigen::Vector2d& corner : in_depth.corners)
        corner = corner.cwiseProduct(seen_by.samples_per_pixel());
    return is_anything_before(in_depth, least_px / seen_by.disparity_px(), seen_by.depth());
}

double DepthSearch::visibility(const Eigen::Vector2d& pixel, double inverse_depth,
                               int view_index) const {
    const ViewSearch& seen_by = view(view_index);
    const auto at = seen_by.line_of(pixel).at(inverse_depth);
    if (!at) return 0;
    const double inside_share = inside(view_index, at->pixel);
    if (inside_share <= 0 || seen_by.depth().empty()) return inside_share;
    const double difference_px =
        std::abs(at->inverse_depth - seen_by.surface_at(at->pixel).inverse_depth) *
        seen_by.disparity_px();
    return inside_share * visibility_of(difference_px, occlusion_tolerance_px_);
}

}  // namespace lumi
