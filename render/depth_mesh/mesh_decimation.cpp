#include "render/depth_mesh/mesh_decimation.h"

#include <bit>
#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

#include "render/depth_mesh/half_edge_collapse.h"

namespace lumi {
namespace {

/// Gathers points; those at the same place are one. Stretched triangles share none with the others:
/// they lie before and behind them.
class PointTable {
 public:
    PointIndex index_of(const DisparityPoint& point, bool is_stretched) {
        const std::uint64_t key = key_of(point) * 2 + (is_stretched ? 1 : 0);
        const auto [begin, end] = indices_.equal_range(key);
        for (auto i = begin; i != end; ++i)
            if (points_[i->second] == point) return i->second;
        const auto index = static_cast<PointIndex>(points_.size());
        points_.push_back(point);
        indices_.emplace(key, index);
        return index;
    }
    [[nodiscard]] std::vector<DisparityPoint> take() { return std::move(points_); }

 private:
    static std::uint64_t key_of(const DisparityPoint& point) {
        std::uint64_t key = 0;
        for (const float value : {point.x(), point.y(), point.z()})
            key = (key ^ std::bit_cast<std::uint32_t>(value)) * 0x9e3779b97f4a7c15U;
        return key >> 1U;
    }
    std::vector<DisparityPoint> points_;
    std::unordered_multimap<std::uint64_t, PointIndex> indices_;
};

DepthMesh mesh_of(const std::vector<DisparityPoint>& points,
                  const std::vector<CollapsingTriangle>& triangles, float disparity_px) {
    DepthMesh mesh;
    std::vector<PointIndex> index_of(points.size(), kNoPoint);
    for (int kind = 0; kind < kDepthKinds; ++kind) {
        for (const CollapsingTriangle& triangle : triangles) {
            if (!triangle.is_alive || triangle.kind != static_cast<DepthKind>(kind)) continue;
            for (const PointIndex corner : triangle.corners) {
                if (index_of[corner] == kNoPoint) {
                    index_of[corner] = static_cast<PointIndex>(mesh.vertices.size());
                    DisparityPoint vertex = points[corner];
                    vertex.z() /= disparity_px;
                    mesh.vertices.push_back(vertex);
                }
                mesh.indices.push_back(index_of[corner]);
            }
        }
        mesh.kind_begin[static_cast<std::size_t>(kind) + 1] = mesh.indices.size();
    }
    return mesh;
}

}  // namespace

DepthMesh decimated(const DepthMesh& mesh, double disparity_px, const DecimationOptions& options) {
    const auto scale = static_cast<float>(disparity_px);
    PointTable table;
    std::vector<CollapsingTriangle> triangles;
    for (int kind = 0; kind < kDepthKinds; ++kind) {
        const std::size_t end = mesh.kind_begin[static_cast<std::size_t>(kind) + 1];
        for (std::size_t i = mesh.kind_begin[static_cast<std::size_t>(kind)]; i < end; i += 3) {
            CollapsingTriangle triangle;
            triangle.kind = static_cast<DepthKind>(kind);
            for (std::size_t corner = 0; corner < 3; ++corner) {
                DisparityPoint point = mesh.vertices[mesh.indices[i + corner]];
                point.z() *= scale;
                triangle.corners[corner] =
                    table.index_of(point, triangle.kind == DepthKind::kStretched);
            }
            const auto& [a, b, c] = triangle.corners;
            if (a != b && b != c && c != a) triangles.push_back(triangle);
        }
    }
    const std::vector<DisparityPoint> points = table.take();
    collapse_half_edges(points, triangles, options);
    return mesh_of(points, triangles, scale);
}

}  // namespace lumi
