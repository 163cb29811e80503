#include "render/depth_mesh/collapsing_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace lumi {
namespace {

/// Triangles do not become thinner than this share of the distance between points looked at.
constexpr float kThinnest = 0.25F;
/// Sides below this share of it, which are those between neighbouring samples, are not looked at.
constexpr float kShort = 0.73F;

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

}  // namespace

CollapsingMesh::CollapsingMesh(std::vector<DisparityPoint> points,
                               std::vector<CollapsingTriangle> triangles, float check_every_px)
    : points_(std::move(points)),
      triangles_(std::move(triangles)),
      ring_of_(points_.size()),
      next_point_(points_.size(), kNoPoint),
      check_every_px_(check_every_px) {
    for (PointIndex t = 0; t < triangles_.size(); ++t)
        for (const PointIndex corner : triangles_[t].corners) ring_of_[corner].push_back(t);
    for (PointIndex t = 0; t < triangles_.size(); ++t) put_points_on_sides(t);
    for (const DisparityPoint& point : points_) {
        const Eigen::Vector2f at = point.head<2>();
        low_ = low_.cwiseMin(at);
        high_ = high_.cwiseMax(at);
    }
}

/// Two planes differ most where their triangles' sides cross: vertices alone do not tell. Of two
/// triangles one puts points on the side that they share.
void CollapsingMesh::put_points_on_sides(PointIndex t) {
    for (std::size_t i = 0; i < 3; ++i) {
        const DisparityPoint from = points_[triangles_[t].corners[i]];
        const DisparityPoint to = points_[triangles_[t].corners[(i + 1) % 3]];
        if (std::pair(from.x(), from.y()) > std::pair(to.x(), to.y())) continue;
        const float length_px = (to - from).head<2>().norm();
        if (length_px < kShort * check_every_px_) continue;
        const int steps = std::max(2, static_cast<int>(length_px / check_every_px_));
        for (int step = 1; step < steps; ++step) {
            const float share = static_cast<float>(step) / static_cast<float>(steps);
            next_point_.push_back(triangles_[t].first_point);
            triangles_[t].first_point = static_cast<PointIndex>(points_.size());
            points_.push_back(from + share * (to - from));
        }
    }
}

bool CollapsingMesh::is_corner_of_photograph(PointIndex vertex) const {
    const Eigen::Vector2f at = points_[vertex].head<2>();
    return (at.x() == low_.x() || at.x() == high_.x()) &&
           (at.y() == low_.y() || at.y() == high_.y());
}

void CollapsingMesh::gather_neighbours(PointIndex vertex,
                                       std::vector<NeighbourVertex>& neighbours) const {
    neighbours.clear();
    for (const PointIndex t : ring_of_[vertex]) {
        const CollapsingTriangle& triangle = triangles_[t];
        const std::size_t at = triangle.place_of(vertex);
        for (const std::size_t turn : {std::size_t{1}, std::size_t{2}}) {
            const PointIndex to = triangle.corners[(at + turn) % 3];
            const std::size_t side = turn == 1 ? at : (at + 2) % 3;
            auto known = std::find_if(neighbours.begin(), neighbours.end(),
                                      [&](const NeighbourVertex& n) { return n.vertex == to; });
            if (known == neighbours.end())
                known = neighbours.insert(known, {to, 0, triangle.kind, false, 0});
            ++known->count;
            known->joins_kinds = known->joins_kinds || triangle.kind != known->kind;
            known->moved_px = std::max(known->moved_px, triangle.moved_px[side]);
        }
    }
}

float CollapsingMesh::error_of_points_px(PointIndex vertex, PointIndex into, float most_px) const {
    float worst_px = 0.0F;
    visit_points(vertex, [&](PointIndex p) {
        worst_px = std::max(worst_px, fit_of(points_[p], vertex, into).error_px);
        return worst_px <= most_px;
    });
    return worst_px;
}

bool CollapsingMesh::keeps_shape(PointIndex vertex, PointIndex into,
                                 const std::vector<NeighbourVertex>& neighbours) const {
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
            std::min(altitude(points_[vertex], b, c), kThinnest * check_every_px_);
        if (before * after <= 0 || altitude(points_[into], b, c) < least_px) return false;
    }
    // The link condition: both ends have no neighbours in common but the removed triangles'.
    std::size_t common = 0;
    for (const NeighbourVertex& neighbour : neighbours) {
        if (neighbour.vertex == into) continue;
        const bool is_common =
            std::any_of(ring_of_[into].begin(), ring_of_[into].end(),
                        [&](PointIndex t) { return triangles_[t].place_of(neighbour.vertex) < 3; });
        if (is_common) ++common;
    }
    return common == removed;
}

CollapsingMesh::Fit CollapsingMesh::fit_of(const DisparityPoint& point, PointIndex vertex,
                                           PointIndex into) const {
    Fit fit{kNoPoint, std::numeric_limits<float>::infinity()};
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

void CollapsingMesh::collapse(PointIndex vertex, PointIndex into) {
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
}

void CollapsingMesh::remove(PointIndex t, PointIndex except) {
    triangles_[t].is_alive = false;
    for (const PointIndex corner : triangles_[t].corners)
        if (corner != except) std::erase(ring_of_[corner], t);
}

void CollapsingMesh::set_moved(PointIndex from, PointIndex to, float moved_px) {
    for (const PointIndex t : ring_of_[from]) {
        CollapsingTriangle& triangle = triangles_[t];
        const std::size_t a = triangle.place_of(from);
        const std::size_t b = triangle.place_of(to);
        if (b < 3) triangle.moved_px[(a + 1) % 3 == b ? a : b] = moved_px;
    }
}

}  // namespace lumi
