#include "render/depth_search/view_search.h"

#include <algorithm>

namespace lumi {
namespace {

/// Steps along an epipolar line, in samples: half the way that is known to be free, but within
/// these.
constexpr double kShortestStep = 1.0;
constexpr double kLongestStep = TiledDepth::kFine;
/// Where the ray would meet the surface no farther ahead than this, in samples, it is tried at
/// once.
constexpr double kAtOnce = 2.0;
constexpr int kMaxSteps = 256;
constexpr int kRefinements = 4;
/// Of the disparity by which one surface differs: a point so close to the surface is not refined.
constexpr double kCloseEnough = 0.25;
/// One that is farther off after all refinements lies in a tear.
constexpr double kMet = 0.5;

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

/// How far to go on, in samples, from a point so far ahead of the surface in inverse depth.
double steps_on(const EpipolarWalk& walk, double ahead) {
    if (ahead <= 0) return kShortestStep;
    const double free = 0.5 * ahead / std::abs(walk.inverse_depth_per_sample());
    return std::clamp(free, kShortestStep, kLongestStep);
}

}  // namespace

ViewSearch::ViewSearch(const LumigraphView& view, const TiledDepth& depth,
                       const ViewGeometry& geometry, const Eye& eye, double max_inverse_depth)
    : view_from_eye_(warp_from(eye).to(view)),
      samples_per_pixel_(static_cast<double>(depth.width()) / view.camera.width_px,
                         static_cast<double>(depth.height()) / view.camera.height_px),
      disparity_px_(disparity_px_per_inverse_depth(geometry, centre_in_world(eye.cam_from_world))),
      max_disparity_px_(max_disparity_px(geometry)),
      focal_times_way_(geometry.focal_px *
                       (centre_in_world(eye.cam_from_world) - geometry.centre_in_world).norm()),
      width_px_(view.camera.width_px),
      height_px_(view.camera.height_px),
      depth_(&depth),
      max_inverse_depth_(max_inverse_depth) {}

// Not calib/capture/bilinear.h: the offsets of tiled memory are found once for the four samples,
// and across a tear nothing is interpolated.
SeenSurface ViewSearch::surface_at_sample(double x, double y) const {
    const TiledDepth& depth = *depth_;
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

ViewSearch::Meeting ViewSearch::meeting_at(const EpipolarWalk& walk, double share) const {
    const EpipolarWalk::Place place = walk.at(share);
    const SeenSurface surface = surface_at_sample(place.x, place.y);
    return {share, surface, place.inverse_depth - surface.inverse_depth};
}

EpipolarLine ViewSearch::line_in_samples(const Eigen::Vector2d& eye_pixel) const {
    EpipolarLine line = line_of(eye_pixel);
    line.at_infinity.head<2>().array() *= samples_per_pixel_.array();
    line.per_inverse_depth.head<2>().array() *= samples_per_pixel_.array();
    return line;
}

RayStretch ViewSearch::visible_stretch(const EpipolarLine& line) const {
    const Eigen::Vector3d& a = line.at_infinity;
    const Eigen::Vector3d& e = line.per_inverse_depth;
    RayStretch stretch{max_inverse_depth_, 0.0};
    const auto keep = [&](double value, double slope) {
        clip_stretch(value, slope, stretch.near_end, stretch.far_end);
    };
    keep(a.z() - kLeastDepthRatio, e.z());
    keep(a.x(), e.x());
    keep(a.y(), e.y());
    keep(depth_->width() * a.z() - a.x(), depth_->width() * e.z() - e.x());
    keep(depth_->height() * a.z() - a.y(), depth_->height() * e.z() - e.y());
    // No nearer to the view than all that it sees, q <= nearest (a.z + q e.z), and no farther than
    // what is taken for the farthest.
    const double nearest = static_cast<double>(depth_->nearest());
    const double farthest = std::max(
        0.0, static_cast<double>(depth_->farthest()) - kAgreeingDisparity_px / max_disparity_px_);
    keep(nearest * a.z(), nearest * e.z() - 1);
    keep(-farthest * a.z(), 1 - farthest * e.z());
    return stretch;
}

std::optional<ViewSearch::Meeting> ViewSearch::close_ahead(const EpipolarWalk& walk,
                                                           const Meeting& from) const {
    const double meets = walk.meets(from.surface.inverse_depth);
    const bool is_close =
        meets >= from.share && meets <= 1 && meets - from.share <= kAtOnce * walk.per_sample();
    if (!is_close) return std::nullopt;
    return meeting_at(walk, meets);
}

std::optional<ViewHit> ViewSearch::crossed(const EpipolarWalk& walk, double before,
                                           double behind) const {
    const double margin = kShortestStep * walk.per_sample();
    return refined(walk, std::max(0.0, before - margin), std::min(1.0, behind + margin));
}

std::optional<ViewHit> ViewSearch::refined(const EpipolarWalk& walk, double before,
                                           double behind) const {
    Meeting at{};
    const auto reaches_surface_at = [&](double share) {
        at = meeting_at(walk, share);
        (at.ahead > 0 ? before : behind) = share;
        return is_at_surface(at, kCloseEnough);
    };
    for (int i = 0; i < kRefinements; ++i) {
        if (reaches_surface_at(0.5 * (before + behind))) break;
        // Where the ray would meet the surface if that were as far as it is here: on slopes
        // steeper than the ray that leads away.
        const double meets = walk.meets(at.surface.inverse_depth);
        if (meets >= before && meets <= behind && reaches_surface_at(meets)) break;
    }
    if (!is_at_surface(at, kMet)) return std::nullopt;
    return hit_at(walk, at);
}

std::optional<ViewHit> ViewSearch::first_hit(const Eigen::Vector2d& eye_pixel) const {
    if (depth_->empty()) return std::nullopt;
    const EpipolarLine line = line_in_samples(eye_pixel);
    const RayStretch stretch = visible_stretch(line);
    if (stretch.is_empty()) return std::nullopt;
    const EpipolarWalk walk(line, stretch, *depth_);
    double share = 0;
    double last_before = 0;
    bool is_before = true;
    for (int step = 0; step < kMaxSteps; ++step) {
        // Whole squares are passed that the ray cannot meet: in front of all that they hold, or,
        // once it is behind a surface, behind all of it.
        if (is_before) {
            const double free_to = walk.past_free(share);
            if (free_to > share) last_before = share = free_to;
        } else {
            share = walk.past_hiding(share);
        }
        Meeting at = meeting_at(walk, share);
        // In front of the surface: there is a hit only where the surface is reached. What is close
        // ahead is tried at once; the point tried may also lie behind the surface.
        if (at.ahead > 0) {
            is_before = true;
            last_before = at.share;
            if (const auto reached = close_ahead(walk, at)) {
                at = *reached;
                if (is_at_surface(at, kCloseEnough)) return hit_at(walk, at);
                if (at.ahead > 0) last_before = at.share;
            }
        }
        // Behind the surface for the first time: it was crossed on the way from `last_before`, or
        // that way leads over a tear, and the ray goes on behind the surface until it comes out. A
        // ray that begins behind has crossed nothing that the view sees: it counts only where it
        // comes in over the photograph's border so close behind that the eye cannot tell.
        if (at.ahead <= 0) {
            const bool begins_behind = at.share == 0;
            if (is_before && (!begins_behind || meets_at_border(at)))
                if (const auto hit = crossed(walk, last_before, at.share)) return hit;
            is_before = false;
        }
        if (at.share >= 1) return std::nullopt;
        share = std::min(1.0, at.share + steps_on(walk, at.ahead) * walk.per_sample());
    }
    return std::nullopt;
}

}  // namespace lumi
