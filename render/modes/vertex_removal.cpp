#include "render/modes/vertex_removal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <unordered_map>

namespace lumi {
namespace {

/// Errors are allowed bit by bit, so that what costs least goes first.
constexpr std::array<double, 3> kShares{0.05, 0.3, 1.0};
/// Triangles thinner than this, twice the area over the square of the longest side, are not made.
constexpr double kThinnest = 0.02;
constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kOnFrame = 1e-3;

using Point = Eigen::Vector3d;

double doubled_area(const Point& a, const Point& b, const Point& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

struct Triangle {
    std::array<std::uint32_t, 3> corners{};
    std::uint32_t group = 0;
    bool is_there = true;
    std::vector<Point> removed;  ///< Vertices that it now stands for.
};

class Surface {
 public:
    Surface(const std::vector<Eigen::Vector3f>& vertices,
            const std::vector<std::vector<std::uint32_t>*>& groups,
            const VertexRemovalOptions& options)
        : vertices_(vertices), options_(options), around_(vertices.size()) {
        for (std::uint32_t group = 0; group < groups.size(); ++group) {
            const std::vector<std::uint32_t>& indices = *groups[group];
            for (std::size_t i = 0; i < indices.size(); i += 3) {
                Triangle triangle{{indices[i], indices[i + 1], indices[i + 2]}, group, true, {}};
                for (const std::uint32_t corner : triangle.corners)
                    around_[corner].push_back(static_cast<std::uint32_t>(triangles_.size()));
                triangles_.push_back(std::move(triangle));
            }
        }
    }

    void simplify() {
        for (const double share : kShares) sweep_until_done(share);
        for (double share = 2; share <= options_.max_relaxation; share *= 2) {
            if (count() <= options_.enough_triangles) break;
            sweep_until_done(share);
        }
    }

    void write(const std::vector<std::vector<std::uint32_t>*>& groups) const {
        for (std::vector<std::uint32_t>* group : groups) group->clear();
        for (const Triangle& triangle : triangles_)
            if (triangle.is_there)
                groups[triangle.group]->insert(groups[triangle.group]->end(),
                                               triangle.corners.begin(), triangle.corners.end());
    }

 private:
    /// The neighbours of a vertex and the triangles around it.
    struct Ring {
        /// Neighbours with how many of the triangles around have them: 2, or 1 along a border.
        std::vector<std::pair<std::uint32_t, int>> neighbours;
        std::array<std::uint32_t, 2> ends{};  ///< Of the border through the vertex.
        bool is_border = false;
        bool is_kept = false;
    };

    [[nodiscard]] std::size_t count() const {
        return static_cast<std::size_t>(
            std::count_if(triangles_.begin(), triangles_.end(),
                          [](const Triangle& triangle) { return triangle.is_there; }));
    }

    /// A vertex that could not be removed is tried again only after something changed around it.
    void sweep_until_done(double share) {
        is_worth_trying_.assign(vertices_.size(), true);
        for (bool any = true; any;) {
            any = false;
            for (std::uint32_t vertex = 0; vertex < around_.size(); ++vertex) {
                if (!is_worth_trying_[vertex] || around_[vertex].empty()) continue;
                is_worth_trying_[vertex] = false;
                if (remove(vertex, share)) any = true;
            }
        }
    }

    [[nodiscard]] Point at(std::uint32_t vertex) const { return vertices_[vertex].cast<double>(); }

    [[nodiscard]] Ring ring_of(std::uint32_t vertex) const {
        Ring ring;
        ring.neighbours.reserve(8);
        const std::vector<std::uint32_t>& around = around_[vertex];
        for (const std::uint32_t index : around) {
            const Triangle& triangle = triangles_[index];
            if (triangle.group != triangles_[around.front()].group) ring.is_kept = true;
            for (const std::uint32_t corner : triangle.corners) {
                if (corner == vertex) continue;
                const auto known =
                    std::find_if(ring.neighbours.begin(), ring.neighbours.end(),
                                 [&](const auto& neighbour) { return neighbour.first == corner; });
                if (known == ring.neighbours.end())
                    ring.neighbours.emplace_back(corner, 1);
                else
                    ++known->second;
            }
        }
        std::size_t ends = 0;
        for (const auto& [neighbour, count] : ring.neighbours) {
            if (count > 2) ring.is_kept = true;
            if (count != 1) continue;
            if (ends < 2) ring.ends[ends] = neighbour;
            ++ends;
        }
        ring.is_border = ends > 0;
        if (ends != 0 && ends != 2) ring.is_kept = true;
        return ring;
    }

    /// True when the segment lies along the same side of the frame as the point.
    [[nodiscard]] bool is_framed(const Point& p, const Point& a, const Point& b) const {
        for (Eigen::Index axis = 0; axis < 2; ++axis)
            for (const double side : {0.0, options_.frame[axis]})
                if (std::abs(p[axis] - side) < kOnFrame && std::abs(a[axis] - side) < kOnFrame &&
                    std::abs(b[axis] - side) < kOnFrame)
                    return true;
        return false;
    }

    [[nodiscard]] bool is_on_frame(const Point& p) const {
        return p.x() < kOnFrame || p.y() < kOnFrame || p.x() > options_.frame.x() - kOnFrame ||
               p.y() > options_.frame.y() - kOnFrame;
    }

    static double distance_to_segment(const Point& p, const Point& a, const Point& b) {
        const Eigen::Vector2d along = (b - a).head<2>();
        const Eigen::Vector2d from = (p - a).head<2>();
        const double length2 = along.squaredNorm();
        const double t = length2 > 0 ? std::clamp(from.dot(along) / length2, 0.0, 1.0) : 0.0;
        return (from - t * along).norm();
    }

    /// A collapse that may be done: the triangles that are left, and what each stands for.
    struct Collapse {
        std::uint32_t target = 0;
        double error = kNever;  ///< As a share of what is allowed.
        std::vector<std::uint32_t> moved;
        std::vector<std::vector<Point>> removed;
    };

    bool remove(std::uint32_t vertex, double share) {
        const Ring ring = ring_of(vertex);
        if (ring.is_kept) return false;
        // Ends of the surface are not given up for fewer triangles.
        if (ring.is_border) share = std::min(share, 1.0);
        std::vector<Point> points{at(vertex)};
        for (const std::uint32_t index : around_[vertex])
            points.insert(points.end(), triangles_[index].removed.begin(),
                          triangles_[index].removed.end());
        std::optional<Collapse> best;
        for (const auto& [target, count] : ring.neighbours)
            if (!ring.is_border || count == 1) consider(vertex, ring, target, points, share, best);
        if (!best) return false;
        apply(vertex, *best);
        if (ring.is_border) join_border(vertex, ring);
        for (const auto& neighbour : ring.neighbours) is_worth_trying_[neighbour.first] = true;
        return true;
    }

    static std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
        return a < b ? (std::uint64_t{a} << 32) | b : (std::uint64_t{b} << 32) | a;
    }

    /// How far the border between the ends would lie from the vertices that it stands for.
    [[nodiscard]] double border_error(std::uint32_t vertex, const Ring& ring) const {
        const Point gone = at(vertex);
        const Point a = at(ring.ends[0]);
        const Point b = at(ring.ends[1]);
        if (is_on_frame(gone)) return is_framed(gone, a, b) ? 0.0 : kNever;
        double distance = distance_to_segment(gone, a, b);
        for (const std::uint32_t end : ring.ends) {
            const auto known = border_removed_.find(edge_key(vertex, end));
            if (known == border_removed_.end()) continue;
            for (const Point& point : known->second)
                distance = std::max(distance, distance_to_segment(point, a, b));
        }
        return distance / options_.max_border_error;
    }

    void join_border(std::uint32_t vertex, const Ring& ring) {
        std::vector<Point> points{at(vertex)};
        for (const std::uint32_t end : ring.ends) {
            const auto known = border_removed_.find(edge_key(vertex, end));
            if (known == border_removed_.end()) continue;
            points.insert(points.end(), known->second.begin(), known->second.end());
            border_removed_.erase(known);
        }
        border_removed_[edge_key(ring.ends[0], ring.ends[1])] = std::move(points);
    }

    void consider(std::uint32_t vertex, const Ring& ring, std::uint32_t target,
                  const std::vector<Point>& points, double share,
                  std::optional<Collapse>& best) const {
        Collapse collapse;
        collapse.target = target;
        collapse.error = 0;
        if (ring.is_border) {
            collapse.error = border_error(vertex, ring);
            if (collapse.error > share) return;
        }
        for (const std::uint32_t index : around_[vertex]) {
            const Triangle& triangle = triangles_[index];
            if (std::find(triangle.corners.begin(), triangle.corners.end(), target) !=
                triangle.corners.end())
                continue;
            if (!stays_upright(moved_corners(index, vertex, target))) return;
            collapse.moved.push_back(index);
        }
        if (collapse.moved.empty()) return;
        collapse.removed.resize(collapse.moved.size());
        for (const Point& point : points) {
            const Place place = lookup(point, vertex, target, collapse);
            collapse.removed[place.triangle].push_back(point);
            collapse.error = std::max(collapse.error, place.error);
            if (collapse.error > share || (best && collapse.error >= best->error)) return;
        }
        // Where edges go, another diagonal of the same corners may not be the same surface.
        for (const auto& [neighbour, count] : ring.neighbours) {
            if (neighbour == target) continue;
            const Point middle = 0.5 * (at(vertex) + at(neighbour));
            collapse.error =
                std::max(collapse.error, lookup(middle, vertex, target, collapse).error);
            if (collapse.error > share || (best && collapse.error >= best->error)) return;
        }
        if (keeps_topology(ring, target)) best = std::move(collapse);
    }

    /// A target that shares more neighbours than those of the edge's triangles would fold the
    /// surface.
    [[nodiscard]] bool keeps_topology(const Ring& ring, std::uint32_t target) const {
        const Ring other = ring_of(target);
        int common = 0;
        int shared_triangles = 0;
        for (const auto& [neighbour, count] : ring.neighbours) {
            if (neighbour == target) shared_triangles = count;
            common += std::any_of(other.neighbours.begin(), other.neighbours.end(),
                                  [&](const auto& of) { return of.first == neighbour; });
        }
        return common == shared_triangles;
    }

    [[nodiscard]] std::array<Point, 3> moved_corners(std::uint32_t triangle, std::uint32_t vertex,
                                                     std::uint32_t target) const {
        std::array<Point, 3> corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t corner = triangles_[triangle].corners[i];
            corners[i] = at(corner == vertex ? target : corner);
        }
        return corners;
    }

    /// Neither turned over nor a sliver.
    static bool stays_upright(const std::array<Point, 3>& corners) {
        const auto& [a, b, c] = corners;
        const double longest2 =
            std::max({(b - a).head<2>().squaredNorm(), (c - b).head<2>().squaredNorm(),
                      (a - c).head<2>().squaredNorm()});
        return doubled_area(a, b, c) < -kThinnest * longest2;
    }

    struct Place {
        std::size_t triangle = 0;  ///< Of those that are moved.
        double error = 0.0;        ///< As a share of what is allowed.
    };

    /// The moved triangle that the point lies in, or else nearest to.
    [[nodiscard]] Place lookup(const Point& point, std::uint32_t vertex, std::uint32_t target,
                               const Collapse& collapse) const {
        double deepest = -kNever;
        double height = 0;
        Place place;
        for (std::size_t i = 0; i < collapse.moved.size(); ++i) {
            const auto [a, b, c] = moved_corners(collapse.moved[i], vertex, target);
            const double area = doubled_area(a, b, c);
            const double share_a = doubled_area(point, b, c) / area;
            const double share_b = doubled_area(a, point, c) / area;
            const double share_c = 1 - share_a - share_b;
            const double inside = std::min({share_a, share_b, share_c});
            if (inside <= deepest) continue;
            deepest = inside;
            height = share_a * a.z() + share_b * b.z() + share_c * c.z();
            place.triangle = i;
        }
        place.error = std::abs(height - point.z()) / options_.max_height_error;
        return place;
    }

    void apply(std::uint32_t vertex, Collapse& collapse) {
        for (const std::uint32_t index : around_[vertex]) {
            Triangle& triangle = triangles_[index];
            if (std::find(collapse.moved.begin(), collapse.moved.end(), index) !=
                collapse.moved.end())
                continue;
            triangle.is_there = false;
            triangle.removed.clear();
            for (const std::uint32_t corner : triangle.corners)
                if (corner != vertex) std::erase(around_[corner], index);
        }
        for (std::size_t i = 0; i < collapse.moved.size(); ++i) {
            Triangle& triangle = triangles_[collapse.moved[i]];
            std::replace(triangle.corners.begin(), triangle.corners.end(), vertex, collapse.target);
            triangle.removed = std::move(collapse.removed[i]);
            around_[collapse.target].push_back(collapse.moved[i]);
        }
        around_[vertex].clear();
    }

    const std::vector<Eigen::Vector3f>& vertices_;
    const VertexRemovalOptions& options_;
    std::vector<Triangle> triangles_;
    std::vector<std::vector<std::uint32_t>> around_;
    std::vector<bool> is_worth_trying_;
    /// Border vertices that an edge of the border stands for.
    std::unordered_map<std::uint64_t, std::vector<Point>> border_removed_;
};

}  // namespace

void weld(const std::vector<Eigen::Vector3f>& vertices,
          const std::vector<std::vector<std::uint32_t>*>& groups) {
    std::vector<std::uint32_t> order(vertices.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto place = [&](std::uint32_t i) {
        return std::tuple(vertices[i].x(), vertices[i].y(), vertices[i].z());
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(place(a), a) < std::tuple(place(b), b);
    });
    std::vector<std::uint32_t> welded(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool is_new = i == 0 || place(order[i]) != place(order[i - 1]);
        welded[order[i]] = is_new ? order[i] : welded[order[i - 1]];
    }
    for (std::vector<std::uint32_t>* group : groups)
        for (std::uint32_t& index : *group) index = welded[index];
}

void remove_vertices(const std::vector<Eigen::Vector3f>& vertices,
                     const std::vector<std::vector<std::uint32_t>*>& groups,
                     const VertexRemovalOptions& options) {
    Surface surface(vertices, groups, options);
    surface.simplify();
    surface.write(groups);
}

}  // namespace lumi
