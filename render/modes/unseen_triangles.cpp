#include "render/modes/unseen_triangles.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "calib/work/parallel_for.h"
#include "render/modes/nearest_views.h"

namespace lumi {
namespace {

/// Other views that are asked one after the other.
constexpr std::size_t kMostAsked = 6;
/// Of a face.
constexpr std::size_t kOwnViews = 3;
/// Corners that one thread looks up at a time.
constexpr std::size_t kCornersAtATime = 32;

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
};

Eigen::Vector2d middle_of(const BlendTriangles& triangles, std::size_t first_index) {
    Eigen::Vector2d sum(0, 0);
    for (std::size_t k = first_index; k < first_index + 3; ++k) {
        sum += vector_of(triangles.vertices[triangles.indices[k]].pixel);
    }
    return sum / 3;
}

std::vector<Eigen::Vector2d> middles_of(const BlendTriangles& triangles,
                                        const std::vector<Candidate>& candidates) {
    std::vector<Eigen::Vector2d> middles;
    for (const Candidate& candidate : candidates)
        middles.push_back(middle_of(triangles, candidate.first_index));
    return middles;
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
        if (standing_of(triangles.vertices[worst]) < best) candidates.push_back({i, worst});
    }
    return candidates;
}

/// Of the face that the triangle is part of; where there are no faces there is one view.
std::vector<int> own_views_of(const Candidate& candidate, const BlendTriangles& triangles,
                              const CameraMesh& mesh) {
    const auto face =
        static_cast<int>(triangles.vertices[triangles.indices[candidate.first_index]].face_index);
    std::vector<int> views;
    if (face < 0) return views;
    for (const int vertex : mesh.faces[static_cast<std::size_t>(face)])
        views.push_back(mesh.vertices[static_cast<std::size_t>(vertex)].view_index);
    return views;
}

/// Candidates by the view that they ask in this round.
using Groups = std::map<int, std::vector<Candidate>>;

Groups grouped(const std::vector<Candidate>& candidates, const BlendTriangles& triangles,
               const CameraMesh& mesh, const NearestViews& nearest, std::size_t round) {
    Groups groups;
    for (const Candidate& candidate : candidates) {
        std::vector<int> others = nearest.at(middle_of(triangles, candidate.first_index));
        for (const int own : own_views_of(candidate, triangles, mesh)) std::erase(others, own);
        if (round < others.size()) groups[others[round]].push_back(candidate);
    }
    return groups;
}

/// The whole picture, looked at through one view.
FacePolygon picture_through(int view) {
    FacePolygon polygon;
    polygon.view_indices = {view, view, view};
    polygon.side_lines = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(),
                          Eigen::Vector3d::Zero()};
    return polygon;
}

/// Corners as another view sees them.
class OtherSights {
 public:
    OtherSights(const PatchSampler& sampler, const BlendTriangles& triangles)
        : sampler_(sampler), triangles_(triangles) {}

    /// Looked up with all that are wanted, unless it was.
    void want(std::uint32_t corner) {
        if (number_of_.try_emplace(corner, wanted_.size()).second) wanted_.push_back(corner);
    }

    /// Makes room for those that are wanted: the first of their numbers. The last is one before
    /// wanted_count().
    [[nodiscard]] std::size_t make_room() {
        const std::size_t first = sights_.size();
        sights_.resize(wanted_.size());
        return first;
    }
    [[nodiscard]] std::size_t wanted_count() const { return wanted_.size(); }
    /// One of those that there is room for; several at once, too.
    void look_up(std::size_t number) {
        sights_[number] =
            blend_vertex(sampler_.at(vector_of(triangles_.vertices[wanted_[number]].pixel)),
                         sampler_.polygon(), VertexDepth::kAffine);
    }

    [[nodiscard]] const BlendVertex& at(std::uint32_t corner) const {
        return sights_[number_of_.at(corner)];
    }
    [[nodiscard]] int view() const { return sampler_.polygon().view_indices[0]; }

 private:
    PatchSampler sampler_;
    const BlendTriangles& triangles_;
    std::vector<std::uint32_t> wanted_;
    std::vector<BlendVertex> sights_;  ///< Of the corners that are wanted, as far as looked up.
    std::unordered_map<std::uint32_t, std::size_t> number_of_;
};

/// Candidates that ask the same view.
struct Asking {
    std::vector<Candidate> candidates;
    OtherSights sights;
};

/// On all cores: few are wanted of most.
void look_up_wanted(std::vector<Asking>& all) {
    std::vector<std::pair<OtherSights*, std::size_t>> wanted;
    for (auto& [candidates, sights] : all)
        for (std::size_t i = sights.make_room(); i < sights.wanted_count(); ++i)
            wanted.emplace_back(&sights, i);
    parallel_for_runs(wanted.size(), kCornersAtATime, 0, [&](std::size_t first, std::size_t end) {
        for (std::size_t i = first; i < end; ++i) wanted[i].first->look_up(wanted[i].second);
    });
}

/// Gives candidates what other views see.
class Takeover {
 public:
    Takeover(const DepthSearch& search, Standing best, BlendTriangles& triangles)
        : search_(search), best_(best), triangles_(triangles) {}

    void take(std::vector<Asking>& all) {
        for (auto& [candidates, sights] : all)
            for (const Candidate& candidate : candidates) sights.want(candidate.worst_corner);
        look_up_wanted(all);
        for (auto& [candidates, sights] : all) {
            std::erase_if(candidates, [&](const Candidate& candidate) {
                return standing_of(sights.at(candidate.worst_corner)) < best_;
            });
            for (const Candidate& candidate : candidates)
                for (std::size_t k = 0; k < 3; ++k)
                    sights.want(triangles_.indices[candidate.first_index + k]);
        }
        look_up_wanted(all);
        for (const Asking& asking : all) take_seen(asking);
    }

 private:
    using Sights = std::array<const BlendVertex*, 3>;

    void take_seen(const Asking& asking) {
        std::unordered_map<std::uint32_t, std::uint32_t> taken;
        for (const Candidate& candidate : asking.candidates) {
            std::uint32_t* corners = &triangles_.indices[candidate.first_index];
            const Sights sights{&asking.sights.at(corners[0]), &asking.sights.at(corners[1]),
                                &asking.sights.at(corners[2])};
            if (!is_seen(sights, asking.sights.view())) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto next = static_cast<std::uint32_t>(triangles_.vertices.size());
                const auto [place, is_new] = taken.try_emplace(corners[k], next);
                if (is_new)
                    triangles_.vertices.push_back(
                        as_seen(*sights[k], triangles_.vertices[corners[k]]));
                corners[k] = place->second;
            }
        }
    }

    [[nodiscard]] bool is_seen(const Sights& corners, int view) const {
        return std::all_of(
                   corners.begin(), corners.end(),
                   [&](const BlendVertex* corner) { return standing_of(*corner) >= best_; }) &&
               sees_between(corners, view);
    }

    /// Whether the view sees the plane through the corners at the middles of the edges and of the
    /// triangle: another surface before it would be drawn on it.
    [[nodiscard]] bool sees_between(const Sights& corners, int view) const {
        constexpr double kThird = 1.0 / 3.0;
        for (const Eigen::Vector3d& shares :
             {Eigen::Vector3d(0.5, 0.5, 0), Eigen::Vector3d(0, 0.5, 0.5),
              Eigen::Vector3d(0.5, 0, 0.5), Eigen::Vector3d(kThird, kThird, kThird)}) {
            Eigen::Vector2d pixel(0, 0);
            double inverse_depth = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const double share = shares[static_cast<Eigen::Index>(k)];
                pixel += share * vector_of(corners[k]->pixel);
                inverse_depth += share * static_cast<double>(corners[k]->inverse_depth);
            }
            if (search_.visibility(pixel, inverse_depth, view) <= 0) return false;
        }
        return true;
    }

    /// A corner as the view sees it.
    static BlendVertex as_seen(const BlendVertex& sight, const BlendVertex& known) {
        BlendVertex taken = sight;
        taken.depth = 1 / sight.depth_ratios[0];
        taken.face_index = known.face_index;
        taken.occluded = known.occluded;
        taken.opacity = known.opacity;
        return taken;
    }

    const DepthSearch& search_;
    Standing best_;
    BlendTriangles& triangles_;
};

}  // namespace

void draw_unseen(const Lumigraph& lumigraph, const Eye& eye, const DepthSearch& search,
                 const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
                 BlendTriangles& triangles) {
    const Standing best = search.has_depth() ? Standing::kSeen : Standing::kGuess;
    std::vector<Candidate> candidates = candidates_among(triangles, best);
    const NearestViews nearest(lumigraph, eye, middles_of(triangles, candidates),
                               kMostAsked + kOwnViews);
    for (std::size_t round = 0; round < kMostAsked && !candidates.empty(); ++round) {
        const Groups groups = grouped(candidates, triangles, lumigraph.mesh, nearest, round);
        std::vector<FacePolygon> pictures;
        for (const auto& [view, members] : groups) pictures.push_back(picture_through(view));
        std::vector<Asking> all;
        for (const auto& [view, members] : groups)
            all.push_back(
                {members, {{pictures[all.size()], search, scene_plane, sampling}, triangles}});
        Takeover(search, best, triangles).take(all);
        std::erase_if(candidates, [&](const Candidate& candidate) {
            return standing_of(
                       triangles.vertices[worst_corner_of(triangles, candidate.first_index)]) >=
                   best;
        });
    }
}

}  // namespace lumi
