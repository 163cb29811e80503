#include "meshing/selection/enclosing_views.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace lumi {
namespace {

constexpr double kLeastCosine = -0.9;  // Of directions that still count: no triangle is so large.
constexpr double kRounding = 1e-9;

struct Candidate {
    int view = 0;
    Eigen::Vector2d at;  ///< Stereographic, the place at the origin: circles stay circles.
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() * b.y() - a.y() * b.x();
}

std::vector<Candidate> projected(const Eigen::Vector3d& place,
                                 const std::vector<Eigen::Vector3d>& directions,
                                 const std::vector<int>& candidates) {
    const Eigen::Vector3d right = place.unitOrthogonal();
    const Eigen::Vector3d up = place.cross(right);
    std::vector<Candidate> result;
    for (const int view : candidates) {
        const Eigen::Vector3d& direction = directions[static_cast<std::size_t>(view)];
        const double cosine = direction.dot(place);
        if (cosine < kLeastCosine) continue;
        result.push_back(
            {view, 2 / (1 + cosine) * Eigen::Vector2d(direction.dot(right), direction.dot(up))});
    }
    return result;
}

/// Barycentric coordinates of the origin; empty when it is outside.
std::optional<Eigen::Vector3d> weights_at_origin(const Eigen::Vector2d& a, const Eigen::Vector2d& b,
                                                 const Eigen::Vector2d& c) {
    const double area = cross(b - a, c - a);
    const Eigen::Vector3d weights(cross(b, c), cross(c, a), cross(a, b));
    if (std::abs(area) <= kRounding * (b - a).squaredNorm()) return std::nullopt;
    const Eigen::Vector3d shares = weights / area;
    return shares.minCoeff() < -kRounding ? std::nullopt : std::optional(shares);
}

double circumradius(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
    return (b - a).norm() * (c - b).norm() * (a - c).norm() / (2 * std::abs(cross(b - a, c - a)));
}

EnclosingViews enclosing_triangle(const std::vector<Candidate>& candidates) {
    EnclosingViews found;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        for (std::size_t j = i + 1; j < candidates.size(); ++j) {
            for (std::size_t k = j + 1; k < candidates.size(); ++k) {
                const Candidate& a = candidates[i];
                const Candidate& b = candidates[j];
                const Candidate& c = candidates[k];
                const auto weights = weights_at_origin(a.at, b.at, c.at);
                if (!weights) continue;
                const double radius = circumradius(a.at, b.at, c.at);
                if (!(radius < least)) continue;
                least = radius;
                found = {{a.view, b.view, c.view}, {weights->x(), weights->y(), weights->z()}};
            }
        }
    }
    return found;
}

/// Short edges before long ones that pass as near.
EnclosingViews nearest_edge(const std::vector<Candidate>& candidates) {
    constexpr double kLengthShare = 0.2;
    EnclosingViews found;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        for (std::size_t j = i + 1; j < candidates.size(); ++j) {
            const Eigen::Vector2d& from = candidates[i].at;
            const Eigen::Vector2d along = candidates[j].at - from;
            const double length = along.norm();
            const double share =
                length > 0 ? std::clamp(-from.dot(along) / (length * length), 0.0, 1.0) : 0.0;
            const double distance = (from + share * along).norm() + kLengthShare * length;
            if (!(distance < least)) continue;
            least = distance;
            found = {{candidates[i].view, candidates[j].view}, {1 - share, share}};
        }
    }
    return found;
}

}  // namespace

EnclosingViews enclosing_views(const Eigen::Vector3d& place,
                               const std::vector<Eigen::Vector3d>& directions,
                               const std::vector<int>& candidates) {
    const std::vector<Candidate> around = projected(place, directions, candidates);
    EnclosingViews found = enclosing_triangle(around);
    if (found.views.empty()) found = nearest_edge(around);
    if (found.views.empty() && !candidates.empty()) return {{candidates.front()}, {1.0}};
    return found;
}

}  // namespace lumi
