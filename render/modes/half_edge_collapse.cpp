#include "render/modes/half_edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace lumi {
namespace {

/// The error allowed grows to the whole in so many rounds, so that what costs least goes first.
constexpr int kRounds = 2;
/// Triangles do not become thinner than this share of the distance between points looked at.
constexpr float kThinnest = 0.25F;
/// Sides below this share of it, which are those between neighbouring samples, are not looked at.
constexpr float kShort = 0.73F;
/// Larger rings of triangles around a vertex are left alone.
constexpr std::size_t kLargestRing = 24;

float doubled_area(const DisparityPoint& a, const DisparityPoint& b, const DisparityPoint& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The smallest of a triangle's.
float altitude(const DisparityPoint& a, const DisparityPoint& b, const DisparityPoint& c) {
    const float squared =
        std::max({(b - a).head<2>().squaredNorm(), (c - b).head<2>().squaredNorm(),
                  (a - c).head<2>().squaredNorm()});
    return squared > 0 ? std::abs(doubled_area(a, b, c)) / std::sqrt(squared) : 0.0F;
}

float distance_to_segment(const DisparityPoint& p, const DisparityPoint& a,
                          const DisparityPoint& b) {
    const Eigen::Vector2f along = (b - a).head<2>();
    const float squared = along.squaredNorm();
    const float share =
        squared > 0 ? std::clamp((p - a).head<2>().dot(along) / squared, 0.0F, 1.0F) : 0.0F;
    return ((p - a).head<2>() - share * along).norm();
}

/// A side of a triangle as others see it.
struct Side {
    PointIndex to = kNoPoint;  ///< Its other end.
    bool is_open = false;      ///< There is nothing beyond it; otherwise another kind.
    float moved_px = 0.0F;
};

/// Drawing a vertex into its neighbour `into`.
struct Collapse {
    PointIndex into = kNoPoint;
    float error_px = 0.0F;
    float moved_px = 0.0F;  ///< Of the border through the vertex.
    PointIndex border_end = kNoPoint;
};

class Collapsing {
 public:
    Collapsing(std::vector<DisparityPoint> points, std::vector<CollapsingTriangle> triangles,
               const DecimationOptions& options)
        : points_(std::move(points)),
          triangles_(std::move(triangles)),
          ring_of_(points_.size()),
          next_point_(points_.size(), kNoPoint),
          options_(options) {
        for (PointIndex t = 0; t < triangles_.size(); ++t)
            for (const PointIndex corner : triangles_[t].corners) ring_of_[corner].push_back(t);
        for (PointIndex t = 0; t < triangles_.size(); ++t) put_points_on_sides(t);
        for (const DisparityPoint& point : points_) {
            const Eigen::Vector2f at = point.head<2>();
            low_ = low_.cwiseMin(at);
            high_ = high_.cwiseMax(at);
        }
    }

    void run() {
        for (int round = kRounds - 1; round >= 0; --round) {
            allowed_share_ = std::ldexp(1.0F, -round);
            for (PointIndex vertex = 0; vertex < ring_of_.size(); ++vertex) {
                const std::optional<Collapse> best = best_collapse(vertex);
                if (best) collapse(vertex, *best);
            }
        }
    }

    [[nodiscard]] std::vector<CollapsingTriangle> take() { return std::move(triangles_); }

 private:
    /// Two planes differ most where their triangles' sides cross: vertices alone do not tell. Of
    /// two triangles one puts points on the side that they share.
    void put_points_on_sides(PointIndex t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const DisparityPoint from = points_[triangles_[t].corners[i]];
            const DisparityPoint to = points_[triangles_[t].corners[(i + 1) % 3]];
            if (std::pair(from.x(), from.y()) > std::pair(to.x(), to.y())) continue;
            const float length_px = (to - from).head<2>().norm();
            if (length_px < kShort * check_every_px()) continue;
            const int steps = std::max(2, static_cast<int>(length_px / check_every_px()));
            for (int step = 1; step < steps; ++step) {
                const float share = static_cast<float>(step) / static_cast<float>(steps);
                next_point_.push_back(triangles_[t].first_point);
                triangles_[t].first_point = static_cast<PointIndex>(points_.size());
                points_.push_back(from + share * (to - from));
            }
        }
    }

    [[nodiscard]] bool is_corner_of_photograph(PointIndex vertex) const {
        const Eigen::Vector2f at = points_[vertex].head<2>();
        return (at.x() == low_.x() || at.x() == high_.x()) &&
               (at.y() == low_.y() || at.y() == high_.y());
    }

    /// The other ends of the sides that leave a vertex, and how often each is met.
    void gather_neighbours(PointIndex vertex) {
        neighbours_.clear();
        for (const PointIndex t : ring_of_[vertex]) {
            const CollapsingTriangle& triangle = triangles_[t];
            const std::size_t at = triangle.place_of(vertex);
            for (const std::size_t turn : {std::size_t{1}, std::size_t{2}}) {
                const PointIndex to = triangle.corners[(at + turn) % 3];
                const std::size_t side = turn == 1 ? at : (at + 2) % 3;
                auto known = std::find_if(neighbours_.begin(), neighbours_.end(),
                                          [&](const Neighbour& n) { return n.vertex == to; });
                if (known == neighbours_.end())
                    known = neighbours_.insert(known, Neighbour{to, 0, triangle.kind, false, 0});
                ++known->count;
                known->joins_kinds = known->joins_kinds || triangle.kind != known->kind;
                known->moved_px = std::max(known->moved_px, triangle.moved_px[side]);
            }
        }
    }

    [[nodiscard]] std::optional<Collapse> best_collapse(PointIndex vertex) {
        const std::vector<PointIndex>& ring = ring_of_[vertex];
        if (ring.empty() || ring.size() > kLargestRing || is_corner_of_photograph(vertex))
            return std::nullopt;
        gather_neighbours(vertex);
        borders_.clear();
        for (const Neighbour& neighbour : neighbours_) {
            if (neighbour.count > 2) return std::nullopt;
            if (neighbour.count == 1 || neighbour.joins_kinds)
                borders_.push_back({neighbour.vertex, neighbour.count == 1, neighbour.moved_px});
        }
        if (!borders_.empty() &&
            (borders_.size() != 2 || borders_[0].is_open != borders_[1].is_open))
            return std::nullopt;
        std::optional<Collapse> best;
        float most_px = allowed_error_px(ring) * allowed_share_;
        for (const Neighbour& neighbour : neighbours_) {
            const std::optional<Collapse> collapse =
                collapse_into(vertex, neighbour.vertex, most_px);
            if (!collapse || (best && collapse->error_px >= best->error_px)) continue;
            best = collapse;
            most_px = collapse->error_px;
        }
        return best;
    }

    [[nodiscard]] float allowed_error_px(const std::vector<PointIndex>& ring) const {
        const bool is_guess = std::none_of(ring.begin(), ring.end(), [&](PointIndex t) {
            return triangles_[t].kind == DepthKind::kSeen;
        });
        return static_cast<float>(is_guess ? options_.guess_error_ratio * options_.max_error_px
                                           : options_.max_error_px);
    }

    /// Empty where the error would be larger than `most_px`, or a border moved too far.
    [[nodiscard]] std::optional<Collapse> collapse_into(PointIndex vertex, PointIndex into,
                                                        float most_px) {
        Collapse collapse{into};
        if (!borders_.empty()) {
            if (borders_[0].to != into && borders_[1].to != into) return std::nullopt;
            collapse.border_end = borders_[borders_[0].to == into ? 1 : 0].to;
            collapse.moved_px =
                distance_to_segment(points_[vertex], points_[into], points_[collapse.border_end]) +
                std::max(borders_[0].moved_px, borders_[1].moved_px);
            const double most_moved_px =
                borders_[0].is_open ? options_.max_tear_px : options_.max_kind_border_px;
            if (static_cast<double>(collapse.moved_px) > most_moved_px) return std::nullopt;
        }
        // What is asked first is what is answered fastest.
        const Fit own = fit_of(points_[vertex], vertex, into);
        if (own.triangle == kNoPoint || !(own.error_px <= most_px)) return std::nullopt;
        if (!keeps_shape(vertex, into)) return std::nullopt;
        collapse.error_px = std::max(own.error_px, error_of_points(vertex, into, most_px));
        if (!(collapse.error_px <= most_px)) return std::nullopt;
        return collapse;
    }

    [[nodiscard]] float check_every_px() const {
        return static_cast<float>(options_.check_every_px);
    }

    /// Triangles neither turn over nor become slivers.
    [[nodiscard]] bool keeps_shape(PointIndex vertex, PointIndex into) const {
        std::size_t removed = 0;
        for (const PointIndex t : ring_of_[vertex]) {
            const CollapsingTriangle& triangle = triangles_[t];
            if (triangle.place_of(into) < 3) {
                ++removed;
                continue;
            }
            const std::size_t at = triangle.place_of(vertex);
            const DisparityPoint& b = points_[triangle.corners[(at + 1) % 3]];
            const DisparityPoint& c = points_[triangle.corners[(at + 2) % 3]];
            const float before = doubled_area(points_[vertex], b, c);
            const float after = doubled_area(points_[into], b, c);
            // Slivers are steep: between the points that are looked at, anything could be.
            const float least_px =
                std::min(altitude(points_[vertex], b, c), kThinnest * check_every_px());
            if (before * after <= 0 || altitude(points_[into], b, c) < least_px) return false;
        }
        // The link condition: both ends have no neighbours in common but the removed triangles'.
        std::size_t common = 0;
        for (const Neighbour& neighbour : neighbours_) {
            if (neighbour.vertex == into) continue;
            const bool is_common = std::any_of(
                ring_of_[into].begin(), ring_of_[into].end(),
                [&](PointIndex t) { return triangles_[t].place_of(neighbour.vertex) < 3; });
            if (is_common) ++common;
        }
        return common == removed;
    }

    /// The error of a point against the triangle of the new ring that it lies in, or nearest to.
    struct Fit {
        PointIndex triangle = kNoPoint;
        float error_px = 0.0F;
    };

    [[nodiscard]] Fit fit_of(const DisparityPoint& point, PointIndex vertex,
                             PointIndex into) const {
        Fit fit;
        float most_inside = -1e30F;
        for (const PointIndex t : ring_of_[vertex]) {
            const CollapsingTriangle& triangle = triangles_[t];
            if (triangle.place_of(into) < 3) continue;
            const std::size_t at = triangle.place_of(vertex);
            const DisparityPoint& a = points_[into];
            const DisparityPoint& b = points_[triangle.corners[(at + 1) % 3]];
            const DisparityPoint& c = points_[triangle.corners[(at + 2) % 3]];
            const float area = doubled_area(a, b, c);
            const float of_b = doubled_area(a, point, c) / area;
            const float of_c = doubled_area(a, b, point) / area;
            const float inside = std::min({1 - of_b - of_c, of_b, of_c});
            if (inside <= most_inside) continue;
            most_inside = inside;
            const float disparity = a.z() + of_b * (b.z() - a.z()) + of_c * (c.z() - a.z());
            fit = {t, std::abs(disparity - point.z())};
        }
        return fit;
    }

    template <class Visit>
    void visit_points(PointIndex vertex, const Visit& visit) const {
        for (const PointIndex t : ring_of_[vertex])
            for (PointIndex p = triangles_[t].first_point; p != kNoPoint; p = next_point_[p])
                if (!visit(p)) return;
    }

    /// The largest of the points that lie in the ring, or one beyond `most_px`.
    [[nodiscard]] float error_of_points(PointIndex vertex, PointIndex into, float most_px) const {
        float worst_px = 0.0F;
        visit_points(vertex, [&](PointIndex p) {
            worst_px = std::max(worst_px, fit_of(points_[p], vertex, into).error_px);
            return worst_px <= most_px;
        });
        return worst_px;
    }

    void collapse(PointIndex vertex, const Collapse& collapse) {
        const PointIndex into = collapse.into;
        gathered_.assign(1, vertex);
        visit_points(vertex, [&](PointIndex p) {
            gathered_.push_back(p);
            return true;
        });
        assigned_.clear();
        for (const PointIndex p : gathered_)
            assigned_.push_back(fit_of(points_[p], vertex, into).triangle);
        for (const PointIndex t : ring_of_[vertex]) {
            CollapsingTriangle& triangle = triangles_[t];
            triangle.first_point = kNoPoint;
            if (triangle.place_of(into) < 3) remove(t, vertex);
        }
        for (const PointIndex t : ring_of_[vertex]) {
            if (!triangles_[t].is_alive) continue;
            triangles_[t].corners[triangles_[t].place_of(vertex)] = into;
            ring_of_[into].push_back(t);
        }
        ring_of_[vertex].clear();
        for (std::size_t i = 0; i < gathered_.size(); ++i) {
            CollapsingTriangle& triangle = triangles_[assigned_[i]];
            next_point_[gathered_[i]] = triangle.first_point;
            triangle.first_point = gathered_[i];
        }
        if (collapse.border_end != kNoPoint)
            set_moved(into, collapse.border_end, collapse.moved_px);
    }

    void remove(PointIndex t, PointIndex except) {
        triangles_[t].is_alive = false;
        for (const PointIndex corner : triangles_[t].corners)
            if (corner != except) std::erase(ring_of_[corner], t);
    }

    void set_moved(PointIndex from, PointIndex to, float moved_px) {
        for (const PointIndex t : ring_of_[from]) {
            CollapsingTriangle& triangle = triangles_[t];
            const std::size_t a = triangle.place_of(from);
            const std::size_t b = triangle.place_of(to);
            if (b < 3) triangle.moved_px[(a + 1) % 3 == b ? a : b] = moved_px;
        }
    }

    struct Neighbour {
        PointIndex vertex = kNoPoint;
        int count = 0;  ///< Triangles at the side to it.
        DepthKind kind = DepthKind::kSeen;
        bool joins_kinds = false;
        float moved_px = 0.0F;
    };

    std::vector<DisparityPoint> points_;  ///< Vertices, then points on sides.
    std::vector<CollapsingTriangle> triangles_;
    std::vector<std::vector<PointIndex>> ring_of_;
    std::vector<PointIndex> next_point_;
    DecimationOptions options_;
    float allowed_share_ = 1.0F;
    Eigen::Vector2f low_ = Eigen::Vector2f::Constant(1e30F);
    Eigen::Vector2f high_ = Eigen::Vector2f::Constant(-1e30F);
    std::vector<Neighbour> neighbours_;
    std::vector<Side> borders_;
    std::vector<PointIndex> gathered_;
    std::vector<PointIndex> assigned_;
};

}  // namespace

void collapse_half_edges(const std::vector<DisparityPoint>& points,
                         std::vector<CollapsingTriangle>& triangles,
                         const DecimationOptions& options) {
    Collapsing collapsing(points, std::move(triangles), options);
    collapsing.run();
    triangles = collapsing.take();
}

}  // namespace lumi
