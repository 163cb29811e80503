#include "render/subdivision/unseen_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

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

/// How well the corner's photographs stand for what is there.
enum class Standing { kNothing, kGuess, kSeen };

Standing standing_of(const BlendVertex& corner) {
    if (corner.weights == std::array<float, 3>{}) return Standing::kNothing;
    return corner.confidence > 0 ? Standing::kSeen : Standing::kGuess;
}

/// A triangle that others may show better.
struct Candidate {
    std::size_t first_index;
    std::uint32_t worst_corner;
    Eigen::Vector2d middle_px;
};

Eigen::Vector2d middle_of(const BlendTriangles& triangles, std::size_t first_index) {
    Eigen::Vector2d sum(0, 0);
    for (std::size_t k = first_index; k < first_index + 3; ++k) {
        sum += vector_of(triangles.vertices[triangles.indices[k]].pixel);
    }
    return sum / 3;
}

std::uint32_t worst_corner_of(const BlendTriangles& triangles, std::size_t first_index) {
    const auto first = triangles.indices.begin() + static_cast<std::ptrdiff_t>(first_index);
    return *std::min_element(first, first + 3, [&](std::uint32_t a, std::uint32_t b) {
        return standing_of(triangles.vertices[a]) < standing_of(triangles.vertices[b]);
    });
}

/// Of triangles with a corner that stands worse than `best`.
std::vector<Candidate> candidates_among(const BlendTriangles& triangles, Standing best) {
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const std::uint32_t worst = worst_corner_of(triangles, i);
        if (standing_of(triangles.vertices[worst]) < best)
            candidates.push_back({i, worst, middle_of(triangles, i)});
    }
    return candidates;
}

/// Those that the triangle is blended from.
std::vector<int> own_views_of(const Candidate& candidate, const BlendTriangles& triangles) {
    const BlendVertex& corner = triangles.vertices[triangles.indices[candidate.first_index]];
    std::vector<int> views;
    for (const float view : corner.view_layers) views.push_back(static_cast<int>(view));
    return views;
}

std::vector<Eigen::Vector2d> middles_of(const std::vector<Candidate>& candidates) {
    std::vector<Eigen::Vector2d> middles;
    middles.reserve(candidates.size());
    for (const Candidate& candidate : candidates) middles.push_back(candidate.middle_px);
    return middles;
}

/// The whole picture, looked at through one view.
FacePolygon picture_through(int view) {
    FacePolygon polygon;
    polygon.view_indices = {view, view, view};
    polygon.side_lines = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(),
                          Eigen::Vector3d::Zero()};
    return polygon;
}

/// A corner of a triangle and a view, as one number.
std::uint64_t key_of(std::uint32_t corner, int view) {
    return (std::uint64_t{corner} << 32) | static_cast<std::uint32_t>(view);
}

using Sights = std::array<const BlendVertex*, 3>;

/// Corners as other views see them, each looked up once.
class OtherSights {
 public:
    OtherSights(const DepthSearch& search, const Eigen::Vector3d& scene_plane,
                const PatchSampler::Options& sampling, const BlendTriangles& triangles)
        : search_(search), scene_plane_(scene_plane), sampling_(sampling), triangles_(triangles) {}

    [[nodiscard]] const BlendVertex& at(std::uint32_t corner, int view) {
        const auto [sight, is_new] = sights_.try_emplace(key_of(corner, view));
        if (is_new) {
            const FacePolygon picture = picture_through(view);
            const PatchSampler sampler(picture, search_, scene_plane_, sampling_);
            sight->second = blend_vertex(sampler.at(vector_of(triangles_.vertices[corner].pixel)),
                                         picture, VertexDepth::kAffine);
        }
        return sight->second;
    }

 private:
    const DepthSearch& search_;
    const Eigen::Vector3d& scene_plane_;
    const PatchSampler::Options& sampling_;
    const BlendTriangles& triangles_;
    std::unordered_map<std::uint64_t, BlendVertex> sights_;
};

/// Whether the view sees the plane through the corners at the middles of the edges and of the
/// triangle: another surface before it would be drawn on it.
bool sees_between(const Sights& corners, const DepthSearch& search, int view) {
    constexpr double kThird = 1.0 / 3.0;
    for (const Eigen::Vector3d& shares :
         {Eigen::Vector3d(0.5, 0.5, 0), Eigen::Vector3d(0, 0.5, 0.5), Eigen::Vector3d(0.5, 0, 0.5),
          Eigen::Vector3d(kThird, kThird, kThird)}) {
        Eigen::Vector2d pixel(0, 0);
        double inverse_depth = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double share = shares[static_cast<Eigen::Index>(k)];
            pixel += share * vector_of(corners[k]->pixel);
            inverse_depth += share * static_cast<double>(corners[k]->inverse_depth);
        }
        if (search.visibility(pixel, inverse_depth, view) <= 0) return false;
    }
    return true;
}

/// A triangle as another view sees it.
struct Taken {
    int view;
    std::array<BlendVertex, 3> corners;
};

/// What the first view sees that sees all of the triangle, of those that come nearest.
std::optional<Taken> first_sight_of(const Candidate& candidate, const BlendTriangles& triangles,
                                    std::vector<int> views, Standing best,
                                    const DepthSearch& search, OtherSights& sights) {
    views.resize(std::min(views.size(), kMostAsked));
    for (const int view : views) {
        if (standing_of(sights.at(candidate.worst_corner, view)) < best) continue;
        Sights corners{};
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = &sights.at(triangles.indices[candidate.first_index + k], view);
        const bool sees_corners =
            std::all_of(corners.begin(), corners.end(),
                        [&](const BlendVertex* corner) { return standing_of(*corner) >= best; });
        if (sees_corners && sees_between(corners, search, view))
            return Taken{view, {*corners[0], *corners[1], *corners[2]}};
    }
    return std::nullopt;
}

/// A corner as the view sees it.
BlendVertex as_seen(const BlendVertex& sight, const BlendVertex& known) {
    BlendVertex taken = sight;
    taken.depth = 1 / sight.depth_ratios[0];
    taken.face_index = known.face_index;
    taken.occluded = known.occluded;
    taken.opacity = known.opacity;
    return taken;
}

/// Gives a triangle the corners that a view sees; those that it shares with others are one.
void take(const Taken& taken, std::uint32_t* corners,
          std::unordered_map<std::uint64_t, std::uint32_t>& numbers, BlendTriangles& triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
        const auto next = static_cast<std::uint32_t>(triangles.vertices.size());
        const auto [number, is_new] = numbers.try_emplace(key_of(corners[k], taken.view), next);
        if (is_new)
            triangles.vertices.push_back(as_seen(taken.corners[k], triangles.vertices[corners[k]]));
        corners[k] = number->second;
    }
}

}  // namespace

void draw_unseen(const Lumigraph& lumigraph, const Eye& eye, const DepthSearch& search,
                 const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
                 BlendTriangles& triangles) {
    const Standing best = search.has_depth() ? Standing::kSeen : Standing::kGuess;
    const std::vector<Candidate> candidates = candidates_among(triangles, best);
    const NearestViews nearest(lumigraph, eye, middles_of(candidates), kMostAsked + kOwnViews);
    std::vector<std::optional<Taken>> taken(candidates.size());
    parallel_for_runs(candidates.size(), kTrianglesAtATime, 0,
                      [&](std::size_t first, std::size_t end) {
                          OtherSights sights(search, scene_plane, sampling, triangles);
                          for (std::size_t i = first; i < end; ++i) {
                              std::vector<int> others = nearest.at(candidates[i].middle_px);
                              for (const int own : own_views_of(candidates[i], triangles))
                                  std::erase(others, own);
                              taken[i] = first_sight_of(candidates[i], triangles, std::move(others),
                                                        best, search, sights);
                          }
                      });
    std::unordered_map<std::uint64_t, std::uint32_t> numbers;
    for (std::size_t i = 0; i < candidates.size(); ++i)
        if (taken[i])
            take(*taken[i], &triangles.indices[candidates[i].first_index], numbers, triangles);
}

}  // namespace lumi
