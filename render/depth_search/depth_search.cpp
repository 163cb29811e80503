#include "render/depth_search/depth_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/depth_search/occlusion.h"
#include "render/faces/shell_opacity.h"

namespace lumi {
namespace {

/// Steps along an epipolar line, in samples: half the way that is known to be free, but within
/// these.
constexpr double kShortestStep = 1.0;
constexpr double kLongestStep = TiledDepth::kFine;
/// A surface that is no farther ahead, in samples, is gone to at once.
constexpr double kAtOnce = 2.0;
constexpr int kMaxSteps = 256;
constexpr int kRefinements = 4;
/// Of the disparity by which one surface differs: a point so close to the surface is not refined.
constexpr double kCloseEnough = 0.25;
/// One that is farther off after all refinements lies in a tear.
constexpr double kMet = 0.5;
/// The nearest an eye can look at lies this many times before the scene's near end.
constexpr double kNearMargin = 100.0;
/// Vertices just outside of a photograph, where a picture ends that is the photograph, still count.
constexpr double kBorderSlack_px = 1.0;
/// What is this share as near as the scene's near end is infinitely far.
constexpr double kFarShare = 1e-4;
/// Of a point's depth in the view over that in the eye, for points that are looked for.
constexpr double kLeastRatio = 1e-6;

/// Cuts from a stretch of q, near end first, what does not satisfy value + q * slope >= 0.
void clip_stretch(double value, double slope, double& near_end, double& far_end) {
    if (slope > 0) {
        far_end = std::max(far_end, -value / slope);
    } else if (slope < 0) {
        near_end = std::min(near_end, -value / slope);
    } else if (value < 0) {
        near_end = far_end - 1;
    }
}

/// Into the range, also what is not a number: the point lies in the view's focal plane.
double clamped(double value, double most) { return std::max(0.0, std::min(most, value)); }

double between(double from, double to, double share) { return from + share * (to - from); }

}  // namespace

DepthSearch::DepthSearch(const Lumigraph& lumigraph, const SearchedViews& views, const Eye& eye)
    : occlusion_tolerance_px_(lumigraph.drawing.occlusion_tolerance_px),
      max_inverse_depth_(kNearMargin * inverse_depth_range(lumigraph).y()),
      least_inverse_depth_(kFarShare * inverse_depth_range(lumigraph).y()) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    std::vector<int> all(lumigraph.views.size());
    std::iota(all.begin(), all.end(), 0);
    agreeing_inverse_depth_ = agreeing_inverse_depth(lumigraph, views.geometries, all, eye_in_world,
                                                     kAgreeingDisparity_px);
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        const LumigraphView& view = lumigraph.views[i];
        const TiledDepth& depth = views.depths[i];
        Target target;
        target.view_from_eye =
            pixel_transfer(view.camera, view.cam_from_world, eye.camera, eye.cam_from_world);
        target.samples_per_pixel = {static_cast<double>(depth.width()) / view.camera.width_px,
                                    static_cast<double>(depth.height()) / view.camera.height_px};
        target.disparity_px = disparity_px_per_inverse_depth(views.geometries[i], eye_in_world);
        target.max_disparity_px = max_disparity_px(views.geometries[i]);
        target.width_px = view.camera.width_px;
        target.height_px = view.camera.height_px;
        target.depth = &depth;
        target.sees_thin = !views.thin[i].indices.empty();
        has_depth_ = has_depth_ || !depth.empty();
        has_thin_ = has_thin_ || target.sees_thin;
        targets_.push_back(target);
    }
}

EpipolarLine DepthSearch::line_in(int view_index, const Eigen::Vector2d& pixel) const {
    const PixelTransfer& transfer = targets_[static_cast<std::size_t>(view_index)].view_from_eye;
    return {transfer.at_infinity * pixel.homogeneous(), transfer.per_inverse_depth};
}

DepthSearch::Surface DepthSearch::surface_at(const Target& target, double x, double y) {
    const TiledDepth& depth = *target.depth;
    const double from_left = clamped(x - 0.5, depth.width() - 1.0);
    const double from_top = clamped(y - 0.5, depth.height() - 1.0);
    const int left = static_cast<int>(from_left);
    const int top = static_cast<int>(from_top);
    const int right = std::min(left + 1, depth.width() - 1);
    const int bottom = std::min(top + 1, depth.height() - 1);
    const double share_right = from_left - left;
    const double share_bottom = from_top - top;
    const std::size_t at_left = TiledDepth::column_offset(left);
    const std::size_t at_right = TiledDepth::column_offset(right);
    const std::size_t at_top = depth.row_offset(top);
    const std::size_t at_bottom = depth.row_offset(bottom);
    const TiledDepth::Sample nearest =
        depth[(share_right < 0.5 ? at_left : at_right) + (share_bottom < 0.5 ? at_top : at_bottom)];
    const TiledDepth::Sample top_left = depth[at_left + at_top];
    if (top_left.is_torn) return {static_cast<double>(nearest.inverse_depth), nearest.kind};
    const auto a = static_cast<double>(top_left.inverse_depth);
    const auto b = static_cast<double>(depth[at_right + at_top].inverse_depth);
    const auto c = static_cast<double>(depth[at_left + at_bottom].inverse_depth);
    const auto d = static_cast<double>(depth[at_right + at_bottom].inverse_depth);
    return {between(between(a, b, share_right), between(c, d, share_right), share_bottom),
            nearest.kind};
}

DepthSearch::Meeting DepthSearch::meeting_at(const Target& target, const EpipolarWalk& walk,
                                             double share) {
    const EpipolarWalk::Place place = walk.at(share);
    const Surface surface = surface_at(target, place.x, place.y);
    return {share, surface, place.inverse_depth - surface.inverse_depth};
}

RayStretch DepthSearch::visible_stretch(const Target& target, const EpipolarLine& line) const {
    const Eigen::Vector3d& a = line.at_infinity;
    const Eigen::Vector3d& e = line.per_inverse_depth;
    RayStretch stretch{max_inverse_depth_, 0.0};
    const auto keep = [&](double value, double slope) {
        clip_stretch(value, slope, stretch.near_end, stretch.far_end);
    };
    keep(a.z() - kLeastRatio, e.z());
    keep(a.x(), e.x());
    keep(a.y(), e.y());
    keep(target.depth->width() * a.z() - a.x(), target.depth->width() * e.z() - e.x());
    keep(target.depth->height() * a.z() - a.y(), target.depth->height() * e.z() - e.y());
    // No nearer to the view than all that it sees, q <= nearest (a.z + q e.z), and no farther than
    // what is taken for the farthest.
    const double nearest = static_cast<double>(target.depth->nearest());
    const double farthest = std::max(0.0, static_cast<double>(target.depth->farthest()) -
                                              kAgreeingDisparity_px / target.max_disparity_px);
    keep(nearest * a.z(), nearest * e.z() - 1);
    keep(-farthest * a.z(), 1 - farthest * e.z());
    return stretch;
}

std::optional<RayHit> DepthSearch::refined(int view_index, const EpipolarWalk& walk, double before,
                                           double behind) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    Meeting at{};
    const auto reaches_surface_at = [&](double share) {
        at = meeting_at(target, walk, share);
        (at.ahead > 0 ? before : behind) = share;
        return is_at_surface(target, at, kCloseEnough);
    };
    for (int i = 0; i < kRefinements; ++i) {
        if (reaches_surface_at(0.5 * (before + behind))) break;
        // Where the ray would meet the surface if that were as far as it is here: on slopes
        // steeper than the ray that leads away.
        const double meets = walk.meets(at.surface.inverse_depth);
        if (meets >= before && meets <= behind && reaches_surface_at(meets)) break;
    }
    if (!is_at_surface(target, at, kMet)) return std::nullopt;
    return hit_at(walk, at, view_index);
}

std::optional<RayHit> DepthSearch::first_hit_in(int view_index,
                                                const Eigen::Vector2d& pixel) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    if (target.depth->empty()) return std::nullopt;
    EpipolarLine line = line_in(view_index, pixel);
    line.at_infinity.head<2>().array() *= target.samples_per_pixel.array();
    line.per_inverse_depth.head<2>().array() *= target.samples_per_pixel.array();
    const RayStretch stretch = visible_stretch(target, line);
    if (stretch.near_end < stretch.far_end) return std::nullopt;
    const EpipolarWalk walk(line, stretch, *target.depth);
    const double per_sample = walk.per_sample();
    double share = 0;
    double last_before = 0;
    bool is_before = true;  // Nothing is nearer than where the stretch begins.
    for (int step = 0; step < kMaxSteps; ++step) {
        if (is_before) {
            const double free_to = walk.past_free(share);
            if (free_to > share) last_before = share = free_to;
        } else {
            share = walk.past_hiding(share);
        }
        Meeting at = meeting_at(target, walk, share);
        if (at.ahead > 0) {
            is_before = true;
            last_before = share;
            const double meets = walk.meets(at.surface.inverse_depth);
            if (meets >= share && meets <= 1 && meets - share <= kAtOnce * per_sample) {
                at = meeting_at(target, walk, meets);
                if (is_at_surface(target, at, kCloseEnough)) return hit_at(walk, at, view_index);
                if (at.ahead > 0) last_before = at.share;
                share = at.share;
            }
        }
        if (at.ahead <= 0) {
            if (is_before) {
                const double margin = kShortestStep * per_sample;
                const auto hit = refined(view_index, walk, std::max(0.0, last_before - margin),
                                         std::min(1.0, share + margin));
                if (hit) return hit;
            }
            is_before = false;
        }
        if (share >= 1) return std::nullopt;
        double steps = kShortestStep;
        if (at.ahead > 0) {
            const double free = 0.5 * at.ahead / std::abs(walk.inverse_depth_per_sample());
            steps = std::clamp(free, kShortestStep, kLongestStep);
        }
        share = std::min(1.0, share + steps * per_sample);
    }
    return std::nullopt;
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
    if (const std::optional<RayHit> seen = nearest_seen(hits)) return seen;
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

double DepthSearch::inside(int view_index, const Eigen::Vector2d& view_pixel) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    return border_fade(kBorderSlack_px +
                       std::min({view_pixel.x(), view_pixel.y(), target.width_px - view_pixel.x(),
                                 target.height_px - view_pixel.y()}));
}

double DepthSearch::inner_share_of(int view_index, const Eigen::Vector2d& view_pixel) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    return inner_share(std::min({view_pixel.x(), view_pixel.y(), target.width_px - view_pixel.x(),
                                 target.height_px - view_pixel.y()}),
                       std::min(target.width_px, target.height_px));
}

double DepthSearch::hidden_by_px(const Eigen::Vector2d& pixel, double inverse_depth,
                                 int view_index) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    const Eigen::Vector3d at = line_in(view_index, pixel).at(inverse_depth);
    if (at.z() <= 0 || target.depth->empty() || inside(view_index, at.hnormalized()) <= 0) return 0;
    const Surface surface = surface_at(target, at);
    if (surface.kind != DepthKind::kSeen) return 0;
    return std::max(0.0, surface.inverse_depth - inverse_depth / at.z()) * target.disparity_px;
}

bool DepthSearch::is_part_hidden(const Footprint& corners, double least_px, int view_index) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    if (!target.sees_thin) return false;
    Footprint in_depth = corners;
    for (Eigen::Vector2d& corner : in_depth.corners)
        corner = corner.cwiseProduct(target.samples_per_pixel);
    return is_anything_before(in_depth, least_px / target.disparity_px, *target.depth);
}

double DepthSearch::visibility(const Eigen::Vector2d& pixel, double inverse_depth,
                               int view_index) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    const Eigen::Vector3d at = line_in(view_index, pixel).at(inverse_depth);
    if (at.z() <= 0) return 0;
    const double inside_share = inside(view_index, at.hnormalized());
    if (inside_share <= 0 || target.depth->empty()) return inside_share;
    const double difference_px =
        std::abs(inverse_depth / at.z() - surface_at(target, at).inverse_depth) *
        target.disparity_px;
    return inside_share * visibility_of(difference_px, occlusion_tolerance_px_);
}

}  // namespace lumi
