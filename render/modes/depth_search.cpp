#include "render/modes/depth_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "render/modes/occlusion.h"
#include "render/modes/shell_opacity.h"

namespace lumi {
namespace {

/// Steps along an epipolar line: half the way that is known to be free, but within these.
constexpr double kShortestStep_px = 1.0;
constexpr double kLongestStep_px = 16.0;
constexpr int kMaxSteps = 256;
/// In tiles: a ray that leaves one is put so far into the next.
constexpr double kBeyondTile = 1e-4;
constexpr int kRefinements = 4;
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

/// The tiles of a view's depth map along an epipolar line.
class TileWalk {
 public:
    TileWalk(const EpipolarLine& line, const Eigen::Vector2d& samples_per_pixel,
             const FloatImage& tiles)
        : start_(line.at_infinity.head<2>().cwiseProduct(samples_per_pixel / kDepthTile)),
          step_(line.per_inverse_depth.head<2>().cwiseProduct(samples_per_pixel / kDepthTile)),
          start_z_(line.at_infinity.z()),
          step_z_(line.per_inverse_depth.z()),
          last_column_(tiles.width() - 1),
          last_row_(tiles.height() - 1) {}

    struct Place {
        double z;
        Eigen::Vector2d at;
        int column;
        int row;
    };
    [[nodiscard]] Place at(double q) const {
        const double z = start_z_ + q * step_z_;
        const Eigen::Vector2d at = (start_ + q * step_) * (1 / z);
        return {z, at, static_cast<int>(clamped(at.x(), last_column_)),
                static_cast<int>(clamped(at.y(), last_row_))};
    }

    /// The inverse depth at which the ray is a little beyond the tile; `far_end` at the least.
    [[nodiscard]] double leaves(const Place& place, double q, double far_end) const {
        double leaves = far_end;
        for (Eigen::Index axis = 0; axis < 2; ++axis) {
            const int tile = axis == 0 ? place.column : place.row;
            const bool falls = step_[axis] > place.at[axis] * step_z_;
            const double border = falls ? tile - kBeyondTile : tile + 1 + kBeyondTile;
            const double there =
                (border * start_z_ - start_[axis]) / (step_[axis] - border * step_z_);
            if (there < q) leaves = std::max(leaves, there);
        }
        return leaves;
    }

 private:
    Eigen::Vector2d start_;
    Eigen::Vector2d step_;
    double start_z_;
    double step_z_;
    int last_column_;
    int last_row_;
};

/// A point on an epipolar line, in pixels of the view.
struct LinePoint {
    double z;  ///< Depth in the view over depth in the eye.
    double inverse_z;
    Eigen::Vector2d pixel;
};

LinePoint point_at(const EpipolarLine& line, double q) {
    const Eigen::Vector3d at = line.at(q);
    const double inverse_z = 1 / at.z();
    return {at.z(), inverse_z, at.head<2>() * inverse_z};
}

/// Pixels that a point moves in the view for each unit of the eye's inverse depth.
double speed_px(const EpipolarLine& line, const LinePoint& at) {
    const Eigen::Vector3d& step = line.per_inverse_depth;
    return (step.head<2>() - at.pixel * step.z()).norm() * std::abs(at.inverse_z);
}

}  // namespace

DepthSearch::DepthSearch(const Lumigraph& lumigraph, const std::vector<ViewGeometry>& geometries,
                         const Eye& eye, double tolerance_px)
    : lumigraph_(lumigraph),
      geometries_(geometries),
      tolerance_px_(tolerance_px),
      max_inverse_depth_(kNearMargin * inverse_depth_range(lumigraph).y()),
      least_inverse_depth_(kFarShare * inverse_depth_range(lumigraph).y()) {
    const Eigen::Vector3d eye_in_world = centre_in_world(eye.cam_from_world);
    std::vector<int> all(lumigraph.views.size());
    std::iota(all.begin(), all.end(), 0);
    agreeing_inverse_depth_ = agreeing_inverse_depth(geometries, all, tolerance_px);
    for (std::size_t i = 0; i < lumigraph.views.size(); ++i) {
        const LumigraphView& view = lumigraph.views[i];
        const FloatImage& depth = view.depth.inverse_depth;
        Target target;
        target.view_from_eye =
            pixel_transfer(view.camera, view.cam_from_world, eye.camera, eye.cam_from_world);
        target.samples_per_pixel = {static_cast<double>(depth.width()) / view.camera.width_px,
                                    static_cast<double>(depth.height()) / view.camera.height_px};
        target.disparity_px = disparity_px_per_inverse_depth(geometries[i], eye_in_world);
        target.max_disparity_px = max_disparity_px(geometries[i]);
        target.max_inverse_depth = geometries[i].max_inverse_depth;
        targets_.push_back(target);
    }
}

EpipolarLine DepthSearch::line_in(int view_index, const Eigen::Vector2d& pixel) const {
    const PixelTransfer& transfer = targets_[static_cast<std::size_t>(view_index)].view_from_eye;
    return {transfer.at_infinity * pixel.homogeneous(), transfer.per_inverse_depth};
}

double DepthSearch::sample_at(int view_index, const Eigen::Vector2d& pixel) const {
    const auto index = static_cast<std::size_t>(view_index);
    const FloatImage& depth = lumigraph_.views[index].depth.inverse_depth;
    const Eigen::Vector2d at = pixel.cwiseProduct(targets_[index].samples_per_pixel);
    return static_cast<double>(depth(static_cast<int>(clamped(at.x(), depth.width() - 1)),
                                     static_cast<int>(clamped(at.y(), depth.height() - 1))));
}

double DepthSearch::surface_at(int view_index, const Eigen::Vector2d& pixel) const {
    const auto index = static_cast<std::size_t>(view_index);
    const FloatImage& map = lumigraph_.views[index].depth.inverse_depth;
    const Eigen::Vector2d at = pixel.cwiseProduct(targets_[index].samples_per_pixel);
    const double x = clamped(at.x() - 0.5, map.width() - 1.0);
    const double y = clamped(at.y() - 0.5, map.height() - 1.0);
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const int right = std::min(left + 1, map.width() - 1);
    const int bottom = std::min(top + 1, map.height() - 1);
    const float a = map(left, top);
    const float b = map(right, top);
    const float c = map(left, bottom);
    const float d = map(right, bottom);
    const double spread = static_cast<double>(std::max({a, b, c, d}) - std::min({a, b, c, d}));
    if (spread * targets_[index].max_disparity_px > 1.0)
        return static_cast<double>(
            map(x - left < 0.5 ? left : right, y - top < 0.5 ? top : bottom));
    // As std::lerp, but for its care for infinities, which would take half of the time.
    const auto between = [](double from, double to, double share) {
        return from + share * (to - from);
    };
    return between(between(static_cast<double>(a), static_cast<double>(b), x - left),
                   between(static_cast<double>(c), static_cast<double>(d), x - left), y - top);
}

DepthKind DepthSearch::kind_at(int view_index, const Eigen::Vector2d& pixel) const {
    const auto index = static_cast<std::size_t>(view_index);
    const GrayImage& confidence = lumigraph_.views[index].depth.confidence;
    const Eigen::Vector2d at = pixel.cwiseProduct(targets_[index].samples_per_pixel);
    return confidence(static_cast<int>(clamped(at.x(), confidence.width() - 1)),
                      static_cast<int>(clamped(at.y(), confidence.height() - 1))) > 0
               ? DepthKind::kSeen
               : DepthKind::kFilled;
}

DepthSearch::Stretch DepthSearch::visible_stretch(int view_index, const EpipolarLine& line) const {
    const auto index = static_cast<std::size_t>(view_index);
    const Camera& camera = lumigraph_.views[index].camera;
    const Eigen::Vector3d& a = line.at_infinity;
    const Eigen::Vector3d& e = line.per_inverse_depth;
    Stretch stretch{max_inverse_depth_, 0.0};
    const auto keep = [&](double value, double slope) {
        clip_stretch(value, slope, stretch.near_end, stretch.far_end);
    };
    keep(a.z() - kLeastRatio, e.z());
    keep(a.x(), e.x());
    keep(a.y(), e.y());
    keep(camera.width_px * a.z() - a.x(), camera.width_px * e.z() - e.x());
    keep(camera.height_px * a.z() - a.y(), camera.height_px * e.z() - e.y());
    // Nearer to the view than anything that it sees: q <= max (a.z + q e.z).
    const double nearest = targets_[index].max_inverse_depth;
    keep(nearest * a.z(), nearest * e.z() - 1);
    return stretch;
}

double DepthSearch::past_free_tiles(int view_index, const EpipolarLine& line, double q,
                                    double far_end) const {
    const auto index = static_cast<std::size_t>(view_index);
    const FloatImage& tiles = geometries_[index].tile_max_inverse_depth;
    const TileWalk walk(line, targets_[index].samples_per_pixel, tiles);
    for (int i = 0; i < tiles.width() + tiles.height(); ++i) {
        const TileWalk::Place place = walk.at(q);
        const double nearest = tiles(place.column, place.row);
        if (q <= nearest * place.z) return q;
        // Where the ray is as far away as what is nearest in the tile, or leaves the tile.
        const double meets =
            nearest * line.at_infinity.z() / (1 - nearest * line.per_inverse_depth.z());
        const double leaves = walk.leaves(place, q, far_end);
        if (meets < q && meets >= leaves) return std::max(far_end, meets);
        if (leaves <= far_end) return far_end;
        q = leaves;
    }
    return q;
}

double DepthSearch::past_hiding_tiles(int view_index, const EpipolarLine& line, double q,
                                      double far_end) const {
    // Farther along the ray is also farther from the view, unless the ray comes back to it.
    if (line.at_infinity.z() <= 0) return q;
    const auto index = static_cast<std::size_t>(view_index);
    const FloatImage& tiles = geometries_[index].tile_min_inverse_depth;
    const TileWalk walk(line, targets_[index].samples_per_pixel, tiles);
    for (int i = 0; i < tiles.width() + tiles.height(); ++i) {
        const TileWalk::Place place = walk.at(q);
        const double farthest = tiles(place.column, place.row);
        if (q >= farthest * place.z) return q;
        const double leaves = walk.leaves(place, q, far_end);
        if (leaves <= far_end) return far_end;
        q = leaves;
    }
    return q;
}

std::optional<RayHit> DepthSearch::refined(int view_index, const EpipolarLine& line,
                                           const Stretch& bracket) const {
    const Target& target = targets_[static_cast<std::size_t>(view_index)];
    double before = bracket.near_end;
    double behind = bracket.far_end;
    double q = behind;
    double ahead = 0;
    Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
    for (int i = 0; i < kRefinements; ++i) {
        q = 0.5 * (before + behind);
        LinePoint at = point_at(line, q);
        double surface = surface_at(view_index, at.pixel);
        // Where the ray is as far away as this surface.
        const double meets =
            surface * line.at_infinity.z() / (1 - surface * line.per_inverse_depth.z());
        ahead = q * at.inverse_z - surface;
        pixel = at.pixel;
        if (meets <= bracket.near_end && meets >= bracket.far_end) {
            q = meets;
            at = point_at(line, q);
            surface = surface_at(view_index, at.pixel);
            ahead = q * at.inverse_z - surface;
            pixel = at.pixel;
            if (std::abs(ahead) * target.max_disparity_px <= 0.25 * tolerance_px_) break;
        }
        (ahead > 0 ? before : behind) = q;
    }
    if (std::abs(ahead) * target.max_disparity_px > tolerance_px_) return std::nullopt;
    return RayHit{q, kind_at(view_index, pixel), 1};
}

std::optional<RayHit> DepthSearch::first_hit_in(int view_index,
                                                const Eigen::Vector2d& pixel) const {
    if (lumigraph_.views[static_cast<std::size_t>(view_index)].depth.inverse_depth.empty())
        return std::nullopt;
    const EpipolarLine line = line_in(view_index, pixel);
    const Stretch stretch = visible_stretch(view_index, line);
    if (stretch.near_end < stretch.far_end) return std::nullopt;
    double q = stretch.near_end;
    double last_before = q;
    bool is_before = true;  // Nothing is nearer than where the stretch begins.
    for (int step = 0; step < kMaxSteps; ++step) {
        if (is_before) {
            const double free_to = past_free_tiles(view_index, line, q, stretch.far_end);
            if (free_to < q) last_before = q = free_to;
        } else {
            q = past_hiding_tiles(view_index, line, q, stretch.far_end);
        }
        const LinePoint at = point_at(line, q);
        const double ahead = q * at.inverse_z - sample_at(view_index, at.pixel);
        const double px_step = 1 / std::max(speed_px(line, at), 1e-12);
        if (ahead > 0) {
            is_before = true;
            last_before = q;
        } else {
            if (is_before) {
                const double margin = kShortestStep_px * px_step;
                const auto hit = refined(view_index, line,
                                         {std::min(stretch.near_end, last_before + margin),
                                          std::max(stretch.far_end, q - margin)});
                if (hit) return hit;
            }
            is_before = false;
        }
        if (q <= stretch.far_end) return std::nullopt;
        const double free_px = 0.5 * ahead * at.z / px_step;
        const double step_px =
            ahead > 0 ? std::clamp(free_px, kShortestStep_px, kLongestStep_px) : kShortestStep_px;
        q = std::max(stretch.far_end, q - step_px * px_step);
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
    DepthKind best_kind = DepthKind::kStretched;
    for (const auto& hit : hits)
        if (hit) best_kind = std::min(best_kind, hit->kind);
    std::optional<RayHit> chosen;
    for (const auto& candidate : hits) {
        if (!candidate || candidate->kind != best_kind) continue;
        RayHit merged{0.0, best_kind, 0};
        for (const auto& other : hits) {
            if (!other || other->kind != best_kind ||
                std::abs(other->inverse_depth - candidate->inverse_depth) > agreeing_inverse_depth_)
                continue;
            merged.inverse_depth += other->inverse_depth;
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
    const Camera& camera = lumigraph_.views[static_cast<std::size_t>(view_index)].camera;
    return border_fade(kBorderSlack_px +
                       std::min({view_pixel.x(), view_pixel.y(), camera.width_px - view_pixel.x(),
                                 camera.height_px - view_pixel.y()}));
}

double DepthSearch::inner_share_of(int view_index, const Eigen::Vector2d& view_pixel) const {
    const Camera& camera = lumigraph_.views[static_cast<std::size_t>(view_index)].camera;
    return inner_share(std::min({view_pixel.x(), view_pixel.y(), camera.width_px - view_pixel.x(),
                                 camera.height_px - view_pixel.y()}),
                       std::min(camera.width_px, camera.height_px));
}

double DepthSearch::visibility(const Eigen::Vector2d& pixel, double inverse_depth,
                               int view_index) const {
    const auto index = static_cast<std::size_t>(view_index);
    const Eigen::Vector3d at = line_in(view_index, pixel).at(inverse_depth);
    if (at.z() <= 0) return 0;
    const Eigen::Vector2d in_view = at.hnormalized();
    const double inside_share = inside(view_index, in_view);
    if (inside_share <= 0 || lumigraph_.views[index].depth.inverse_depth.empty())
        return inside_share;
    const double difference_px =
        std::abs(inverse_depth / at.z() - surface_at(view_index, in_view)) *
        targets_[index].disparity_px;
    return inside_share * visibility_of(difference_px, tolerance_px_);
}

}  // namespace lumi
