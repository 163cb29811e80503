#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "render/lumigraph/depth_mesh.h"

namespace lumi {

/// (x, y) of the photograph and the disparity, all in pixels.
using DisparityPoint = Eigen::Vector3f;
using PointIndex = std::uint32_t;
constexpr PointIndex kNoPoint = 0xffffffffU;

/// A triangle of a mesh whose vertices are drawn into one another.
struct CollapsingTriangle {
    std::array<PointIndex, 3> corners{};
    DepthKind kind = DepthKind::kSeen;
    bool is_alive = true;
    PointIndex first_point = kNoPoint;  ///< Of those left out that lie in it, as a chain.
    std::array<float, 3> moved_px{};    ///< How far the side from corner i on is from where it was.

    /// 3 where the vertex is no corner.
    [[nodiscard]] std::size_t place_of(PointIndex vertex) const {
        return corners[0] == vertex ? 0 : corners[1] == vertex ? 1 : corners[2] == vertex ? 2 : 3;
    }
};

/// The other end of the sides that leave a vertex.
struct NeighbourVertex {
    PointIndex vertex = kNoPoint;
    int count = 0;  ///< Triangles at the side to it.
    DepthKind kind = DepthKind::kSeen;
    bool joins_kinds = false;
    float moved_px = 0.0F;
};

/// Triangles that know their neighbours and the points that were left out in them, so that it can
/// be told what drawing a vertex into a neighbour does to the surface.
class CollapsingMesh {
 public:
    /// Besides the vertices, points on sides are looked at, no farther apart than
    /// `check_every_px`.
    CollapsingMesh(std::vector<DisparityPoint> points, std::vector<CollapsingTriangle> triangles,
                   float check_every_px);

    [[nodiscard]] std::size_t vertex_count() const { return ring_of_.size(); }
    [[nodiscard]] const DisparityPoint& point(PointIndex index) const { return points_[index]; }
    [[nodiscard]] const CollapsingTriangle& triangle(PointIndex index) const {
        return triangles_[index];
    }
    /// The triangles around a vertex.
    [[nodiscard]] const std::vector<PointIndex>& ring_of(PointIndex vertex) const {
        return ring_of_[vertex];
    }
    [[nodiscard]] bool is_corner_of_photograph(PointIndex vertex) const;
    void gather_neighbours(PointIndex vertex, std::vector<NeighbourVertex>& neighbours) const;

    /// How far the vertex itself would be from the surface; infinitely, if none were left.
    [[nodiscard]] float error_of_vertex_px(PointIndex vertex, PointIndex into) const {
        return fit_of(points_[vertex], vertex, into).error_px;
    }
    /// The same for the farthest of the points that lie around it, or for one beyond `most_px`.
    [[nodiscard]] float error_of_points_px(PointIndex vertex, PointIndex into, float most_px) const;
    /// Whether triangles neither turn over nor become slivers, and the mesh stays one surface:
    /// `neighbours` are those of the vertex.
    [[nodiscard]] bool keeps_shape(PointIndex vertex, PointIndex into,
                                   const std::vector<NeighbourVertex>& neighbours) const;

    void collapse(PointIndex vertex, PointIndex into);
    /// Notes how far the side between two vertices is from where it was.
    void set_moved(PointIndex from, PointIndex to, float moved_px);

    [[nodiscard]] std::vector<CollapsingTriangle> take() { return std::move(triangles_); }

 private:
    /// Of a point against the triangle that it comes to lie in, or nearest to.
    struct Fit {
        PointIndex triangle = kNoPoint;
        float error_px = 0.0F;
    };
    [[nodiscard]] Fit fit_of(const DisparityPoint& point, PointIndex vertex, PointIndex into) const;
    void put_points_on_sides(PointIndex triangle);
    void remove(PointIndex triangle, PointIndex except);
    /// Those left out in the triangles around a vertex, while `visit` returns true.
    template <class Visit>
    void visit_points(PointIndex vertex, const Visit& visit) const {
        for (const PointIndex t : ring_of_[vertex])
            for (PointIndex p = triangles_[t].first_point; p != kNoPoint; p = next_point_[p])
                if (!visit(p)) return;
    }

    std::vector<DisparityPoint> points_;  ///< Vertices, then points on sides.
    std::vector<CollapsingTriangle> triangles_;
    std::vector<std::vector<PointIndex>> ring_of_;
    std::vector<PointIndex> next_point_;
    float check_every_px_;
    Eigen::Vector2f low_ = Eigen::Vector2f::Constant(1e30F);
    Eigen::Vector2f high_ = Eigen::Vector2f::Constant(-1e30F);
    std::vector<PointIndex> gathered_;
    std::vector<PointIndex> assigned_;
};

}  // namespace lumi
