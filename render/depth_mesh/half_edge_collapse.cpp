#include "render/depth_mesh/half_edge_collapse.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace lumi {
namespace {

/// The error allowed grows to the whole in so many rounds, so that what costs least goes first.
constexpr int kRounds = 2;
/// Larger rings of triangles around a vertex are left alone.
constexpr std::size_t kLargestRing = 24;

float distance_to_segment(const DisparityPoint& p, const DisparityPoint& a,
                          const DisparityPoint& b) {
    const Eigen::Vector2f along = (b - a).head<2>();
    const float squared = along.squaredNorm();
    const float share =
        squared > 0 ? std::clamp((p - a).head<2>().dot(along) / squared, 0.0F, 1.0F) : 0.0F;
    return ((p - a).head<2>() - share * along).norm();
}

/// A side along which the surface ends, or another kind begins.
struct BorderSide {
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

/// Which vertices are drawn into which.
class Collapsing {
 public:
    Collapsing(CollapsingMesh& mesh, const DecimationOptions& options)
        : mesh_(mesh), options_(options) {}

    void run() {
        for (int round = kRounds - 1; round >= 0; --round) {
            const float allowed_share = std::ldexp(1.0F, -round);
            for (PointIndex vertex = 0; vertex < mesh_.vertex_count(); ++vertex) {
                const std::optional<Collapse> best = best_collapse(vertex, allowed_share);
                if (!best) continue;
                mesh_.collapse(vertex, best->into);
                if (best->border_end != kNoPoint)
                    mesh_.set_moved(best->into, best->border_end, best->moved_px);
            }
        }
    }

 private:
    [[nodiscard]] std::optional<Collapse> best_collapse(PointIndex vertex, float allowed_share) {
        const std::vector<PointIndex>& ring = mesh_.ring_of(vertex);
        if (ring.empty() || ring.size() > kLargestRing || mesh_.is_corner_of_photograph(vertex))
            return std::nullopt;
        mesh_.gather_neighbours(vertex, neighbours_);
        if (!gather_borders()) return std::nullopt;
        const double slack = slack_of(ring);
        most_moved_tear_px_ = slack * options_.max_tear_px;
        float most_px = static_cast<float>(slack * options_.max_error_px) * allowed_share;
        std::optional<Collapse> best;
        for (const NeighbourVertex& neighbour : neighbours_) {
            const std::optional<Collapse> collapse =
                collapse_into(vertex, neighbour.vertex, most_px);
            if (!collapse || (best && collapse->error_px >= best->error_px)) continue;
            best = collapse;
            most_px = collapse->error_px;
        }
        return best;
    }

    /// False where more meets than one border that runs through the vertex.
    [[nodiscard]] bool gather_borders() {
        borders_.clear();
        for (const NeighbourVertex& neighbour : neighbours_) {
            if (neighbour.count > 2) return false;
            if (neighbour.count == 1 || neighbour.joins_kinds)
                borders_.push_back({neighbour.vertex, neighbour.count == 1, neighbour.moved_px});
        }
        return borders_.empty() ||
               (borders_.size() == 2 && borders_[0].is_open == borders_[1].is_open);
    }

    /// So many times the error, and the move of a tear, may be what they may be otherwise.
    [[nodiscard]] double slack_of(const std::vector<PointIndex>& ring) const {
        const bool is_guess = std::none_of(ring.begin(), ring.end(), [&](PointIndex t) {
            return mesh_.triangle(t).kind == DepthKind::kSeen;
        });
        return is_guess ? options_.guess_error_ratio : 1.0;
    }

    /// Empty where the error would be larger than `most_px`, or a border moved too far.
    [[nodiscard]] std::optional<Collapse> collapse_into(PointIndex vertex, PointIndex into,
                                                        float most_px) const {
        Collapse collapse{into};
        if (!borders_.empty()) {
            if (borders_[0].to != into && borders_[1].to != into) return std::nullopt;
            collapse.border_end = borders_[borders_[0].to == into ? 1 : 0].to;
            collapse.moved_px = distance_to_segment(mesh_.point(vertex), mesh_.point(into),
                                                    mesh_.point(collapse.border_end)) +
                                std::max(borders_[0].moved_px, borders_[1].moved_px);
            const double most_moved_px =
                borders_[0].is_open ? most_moved_tear_px_ : options_.max_kind_border_px;
            if (static_cast<double>(collapse.moved_px) > most_moved_px) return std::nullopt;
        }
        // What is asked first is what is answered fastest.
        const float own_px = mesh_.error_of_vertex_px(vertex, into);
        if (!(own_px <= most_px) || !mesh_.keeps_shape(vertex, into, neighbours_))
            return std::nullopt;
        collapse.error_px = std::max(own_px, mesh_.error_of_points_px(vertex, into, most_px));
        if (!(collapse.error_px <= most_px)) return std::nullopt;
        return collapse;
    }

    CollapsingMesh& mesh_;
    DecimationOptions options_;
    double most_moved_tear_px_ = 0.0;  ///< Of the vertex at hand.
    std::vector<NeighbourVertex> neighbours_;
    std::vector<BorderSide> borders_;
};

}  // namespace

void collapse_half_edges(const std::vector<DisparityPoint>& points,
                         std::vector<CollapsingTriangle>& triangles,
                         const DecimationOptions& options) {
    CollapsingMesh mesh(points, std::move(triangles), static_cast<float>(options.check_every_px));
    Collapsing(mesh, options).run();
    triangles = mesh.take();
}

}  // namespace lumi
