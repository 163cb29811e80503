#include "render/subdivision/seen_parts.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

/// In the middle of an edge: where it is, and what no other view tells (SeenCorners).
BlendVertex edge_middle(const BlendVertex& a, const BlendVertex& b) {
    BlendVertex middle = a;
    for (std::size_t i = 0; i < middle.pixel.size(); ++i)
        middle.pixel[i] = 0.5F * (a.pixel[i] + b.pixel[i]);
    middle.opacity = 0.5F * (a.opacity + b.opacity);
    middle.occluded = 0.5F * (a.occluded + b.occluded);
    return middle;
}

double longest_edge_px(const TriangleCorners& corners, const std::vector<BlendVertex>& vertices) {
    double longest = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Eigen::Vector2d from = vector_of(vertices[corners[k]].pixel);
        const Eigen::Vector2d to = vector_of(vertices[corners[(k + 1) % corners.size()]].pixel);
        longest = std::max(longest, (to - from).norm());
    }
    return longest;
}

/// Neighbours mostly, which are divided by one thread.
constexpr std::size_t kWholesAtATime = 16;

/// Some triangles, divided and asked for again and again.
class DividedTriangles {
 public:
    DividedTriangles(std::vector<UnseenTriangle> wholes, const std::vector<BlendVertex>& vertices)
        : triangles_(std::move(wholes)) {
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

    /// What is seen of quarters, of their quarters, and so on.
    [[nodiscard]] std::vector<BlendTriangles> seen_by_division(const AskedViews& asked,
                                                               double long_edge_px) {
        std::vector<BlendTriangles> by_division;
        SightSearch search(asked, vertices_);
        for (quarter(long_edge_px); !triangles_.empty(); quarter(long_edge_px))
            by_division.push_back(take_seen(search));
        return by_division;
    }

 private:
    /// Makes four of each that is long enough, and drops the others.
    void quarter(double long_edge_px) {
        std::vector<UnseenTriangle> quarters;
        for (const auto& [corners, asked_views] : triangles_) {
            if (longest_edge_px(corners, vertices_) < long_edge_px) continue;
            const auto [a, b, c] = corners;
            const std::uint32_t ab = middle(a, b);
            const std::uint32_t bc = middle(b, c);
            const std::uint32_t ca = middle(c, a);
            for (const TriangleCorners& part :
                 {TriangleCorners{a, ab, ca}, TriangleCorners{ab, b, bc},
                  TriangleCorners{ca, bc, c}, TriangleCorners{ab, bc, ca}})
                quarters.push_back({part, asked_views});
        }
        triangles_ = std::move(quarters);
    }

    /// Those that a view sees whole; those that are seen in part are left.
    [[nodiscard]] BlendTriangles take_seen(SightSearch& search) {
        BlendTriangles seen;
        SeenCorners seen_corners;
        std::vector<UnseenTriangle> rest;
        for (const UnseenTriangle& triangle : triangles_) {
            OtherSights sights = search.sights_of(triangle);
            if (sights.whole) {
                const TriangleCorners corners = seen_corners.corners_of(
                    *sights.whole, triangle.corners, vertices_, seen.vertices);
                seen.indices.insert(seen.indices.end(), corners.begin(), corners.end());
            } else if (!sights.partly_seeing.empty()) {
                rest.push_back({triangle.corners, std::move(sights.partly_seeing)});
            }
        }
        triangles_ = std::move(rest);
        return seen;
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

/// Appends what there is room for.
void append(const BlendTriangles& more, std::size_t max_count, BlendTriangles& triangles) {
    const std::size_t room =
        max_count == 0 ? more.count() : max_count - std::min(max_count, triangles.count());
    if (room == 0) return;
    const auto before = static_cast<std::uint32_t>(triangles.vertices.size());
    triangles.vertices.insert(triangles.vertices.end(), more.vertices.begin(), more.vertices.end());
    for (std::size_t i = 0; i < 3 * std::min(room, more.count()); ++i)
        triangles.indices.push_back(before + more.indices[i]);
}

}  // namespace

BlendTriangles seen_parts(const std::vector<UnseenTriangle>& partly_seen,
                          const std::vector<BlendVertex>& vertices, const AskedViews& asked,
                          const SeenPartsOptions& options) {
    assert(options.long_edge_px > 0);
    std::vector<std::vector<BlendTriangles>> runs((partly_seen.size() + kWholesAtATime - 1) /
                                                  kWholesAtATime);
    parallel_for_runs(
        partly_seen.size(), kWholesAtATime, 0, [&](std::size_t first, std::size_t end) {
            const auto begin = partly_seen.begin();
            DividedTriangles divided({begin + static_cast<std::ptrdiff_t>(first),
                                      begin + static_cast<std::ptrdiff_t>(end)},
                                     vertices);
            runs[first / kWholesAtATime] = divided.seen_by_division(asked, options.long_edge_px);
        });
    std::size_t divisions = 0;
    for (const std::vector<BlendTriangles>& run : runs) divisions = std::max(divisions, run.size());
    BlendTriangles parts;
    for (std::size_t division = 0; division < divisions; ++division)
        for (const std::vector<BlendTriangles>& run : runs)
            if (division < run.size()) append(run[division], options.max_parts, parts);
    return parts;
}

}  // namespace lumi
