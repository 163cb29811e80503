#include "render/subdivision/unseen_triangles.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "calib/work/parallel_for.h"
#include "render/view_choice/nearest_views.h"

namespace lumi {
namespace {

/// Other views that are asked one after the other.
constexpr std::size_t kMostAsked = 6;
/// Of a face.
constexpr std::size_t kOwnViews = 3;
/// Triangles that are neighbours mostly, whose corners one thread looks up once.
constexpr std::size_t kTrianglesAtATime = 64;

/// Triangles of a list, and where in it they begin.
struct Unseen {
    std::vector<UnseenTriangle> triangles;
    std::vector<std::size_t> first_indices;
};

Eigen::Vector2d middle_px(const TriangleCorners& corners,
                          const std::vector<BlendVertex>& vertices) {
    Eigen::Vector2d sum(0, 0);
    for (const std::uint32_t corner : corners) sum += vector_of(vertices[corner].pixel);
    return sum / 3;
}

/// The nearest views beside those that the corner is blended from.
std::vector<int> others_of(const BlendVertex& corner, std::vector<int> nearest) {
    for (const float own : corner.view_layers) std::erase(nearest, static_cast<int>(own));
    nearest.resize(std::min(nearest.size(), kMostAsked));
    return nearest;
}

/// Triangles with a corner that stands worse than `best`.
Unseen unseen_among(const BlendTriangles& triangles, const Lumigraph& lumigraph, const Eye& eye,
                    Standing best) {
    Unseen unseen;
    std::vector<Eigen::Vector2d> middles_px;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const TriangleCorners corners{triangles.indices[i], triangles.indices[i + 1],
                                      triangles.indices[i + 2]};
        const bool is_unseen = std::any_of(
            corners.begin(), corners.end(),
            [&](std::uint32_t corner) { return standing_of(triangles.vertices[corner]) < best; });
        if (!is_unseen) continue;
        unseen.triangles.push_back({corners, {}});
        unseen.first_indices.push_back(i);
        middles_px.push_back(middle_px(corners, triangles.vertices));
    }
    const NearestViews nearest(lumigraph, eye, middles_px, kMostAsked + kOwnViews);
    for (std::size_t i = 0; i < middles_px.size(); ++i) {
        UnseenTriangle& triangle = unseen.triangles[i];
        triangle.asked_views =
            others_of(triangles.vertices[triangle.corners[0]], nearest.at(middles_px[i]));
    }
    return unseen;
}

std::vector<OtherSights> sights_of_all(const std::vector<UnseenTriangle>& triangles,
                                       const std::vector<BlendVertex>& vertices,
                                       const AskedViews& asked) {
    std::vector<OtherSights> sights(triangles.size());
    parallel_for_runs(triangles.size(), kTrianglesAtATime, 0,
                      [&](std::size_t first, std::size_t end) {
                          SightSearch search(asked, vertices);
                          for (std::size_t i = first; i < end; ++i)
                              sights[i] = search.sights_of(triangles[i]);
                      });
    return sights;
}

}  // namespace

std::vector<UnseenTriangle> draw_unseen(const Lumigraph& lumigraph, const Eye& eye,
                                        const DepthSearch& search,
                                        const Eigen::Vector3d& scene_plane,
                                        const PatchSampler::Options& sampling,
                                        BlendTriangles& triangles) {
    const auto [unseen, first_indices] =
        unseen_among(triangles, lumigraph, eye, best_standing(search));
    std::vector<OtherSights> sights =
        sights_of_all(unseen, triangles.vertices, {search, scene_plane, sampling});
    std::vector<UnseenTriangle> partly_seen;
    SeenCorners seen;
    for (std::size_t i = 0; i < unseen.size(); ++i) {
        if (sights[i].whole) {
            const TriangleCorners corners = seen.corners_of(*sights[i].whole, unseen[i].corners,
                                                            triangles.vertices, triangles.vertices);
            std::copy(corners.begin(), corners.end(),
                      triangles.indices.begin() + static_cast<std::ptrdiff_t>(first_indices[i]));
        } else if (!sights[i].partly_seeing.empty()) {
            partly_seen.push_back({unseen[i].corners, std::move(sights[i].partly_seeing)});
        }
    }
    return partly_seen;
}

}  // namespace lumi
