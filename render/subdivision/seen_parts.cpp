#include "render/subdivision/seen_parts.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

namespace lumi {
namespace {

/// In the middle of an edge: only where it is, and of which face, is asked for.
BlendVertex edge_middle(const BlendVertex& a, const BlendVertex& b) {
    BlendVertex middle = a;
    for (std::size_t i = 0; i < middle.pixel.size(); ++i)
        middle.pixel[i] = 0.5F * (a.pixel[i] + b.pixel[i]);
    middle.opacity = 0.5F * (a.opacity + b.opacity);
    return middle;
}

/// Triangles that are divided, with vertices of their own.
class DividedTriangles {
 public:
    DividedTriangles(const std::vector<UnseenTriangle>& wholes,
                     const std::vector<BlendVertex>& vertices)
        : triangles_(wholes) {
        std::unordered_map<std::uint32_t, std::uint32_t> numbers;
        for (UnseenTriangle& triangle : triangles_) {
            for (std::uint32_t& corner : triangle.corners) {
                const auto next = static_cast<std::uint32_t>(vertices_.size());
                const auto [number, is_new] = numbers.try_emplace(corner, next);
                if (is_new) vertices_.push_back(vertices[corner]);
                corner = number->second;
            }
        }
    }

    [[nodiscard]] const std::vector<UnseenTriangle>& triangles() const { return triangles_; }
    [[nodiscard]] const std::vector<BlendVertex>& vertices() const { return vertices_; }

    /// Makes four of each that is long enough, and drops the others.
    void quarter(double min_edge_px) {
        std::vector<UnseenTriangle> quarters;
        for (const auto& [corners, asked_views] : triangles_) {
            if (longest_edge_px(corners) < 2 * min_edge_px) continue;
            const auto [a, b, c] = corners;
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            for (const TriangleCorners& quarter :
                 {TriangleCorners{a, ab, ca}, TriangleCorners{ab, b, bc},
                  TriangleCorners{ca, bc, c}, TriangleCorners{ab, bc, ca}})
                quarters.push_back({quarter, asked_views});
        }
        triangles_ = std::move(quarters);
    }

    void replace(std::vector<UnseenTriangle> triangles) { triangles_ = std::move(triangles); }

 private:
    [[nodiscard]] double longest_edge_px(const TriangleCorners& corners) const {
        double longest = 0;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const Eigen::Vector2d from = vector_of(vertices_[corners[k]].pixel);
            const Eigen::Vector2d to =
                vector_of(vertices_[corners[(k + 1) % corners.size()]].pixel);
            longest = std::max(longest, (to - from).norm());
        }
        return longest;
    }

    std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
        const auto next = static_cast<std::uint32_t>(vertices_.size());
        const auto [number, is_new] = middles_.try_emplace(std::minmax(a, b), next);
        if (is_new) vertices_.push_back(edge_middle(vertices_[a], vertices_[b]));
        return number->second;
    }

    std::vector<UnseenTriangle> triangles_;
    std::vector<BlendVertex> vertices_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace

BlendTriangles seen_parts(const std::vector<UnseenTriangle>& partly_seen,
                          const std::vector<BlendVertex>& vertices, const AskedViews& asked,
                          const SeenPartsOptions& options) {
    BlendTriangles parts;
    SeenCorners seen;
    DividedTriangles divided(partly_seen, vertices);
    for (divided.quarter(options.min_edge_px); !divided.triangles().empty();
         divided.quarter(options.min_edge_px)) {
        std::vector<OtherSights> sights =
            other_sights(divided.triangles(), divided.vertices(), asked);
        std::vector<UnseenTriangle> rest;
        for (std::size_t i = 0; i < sights.size(); ++i) {
            const UnseenTriangle& part = divided.triangles()[i];
            if (sights[i].whole) {
                if (options.max_parts > 0 && parts.count() == options.max_parts) return parts;
                const TriangleCorners corners = seen.corners_of(*sights[i].whole, part.corners,
                                                                divided.vertices(), parts.vertices);
                parts.indices.insert(parts.indices.end(), corners.begin(), corners.end());
            } else if (!sights[i].partly_seeing.empty()) {
                rest.push_back({part.corners, std::move(sights[i].partly_seeing)});
            }
        }
        divided.replace(std::move(rest));
    }
    return parts;
}

}  // namespace lumi
