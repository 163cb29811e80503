#include "render/modes/unseen_triangles.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "calib/work/parallel_for.h"

namespace lumi {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
/// The weight of the next view beside one that sees the point: it counts where that does not.
constexpr double kNextWeight = 1e-3;
/// Corners that one thread looks up at a time.
constexpr std::size_t kCornersAtATime = 64;

/// How well the corner's photographs stand for what is there.
enum class Standing { kNothing, kGuess, kSeen };

Standing standing_of(const BlendVertex& corner) {
    if (corner.weights == std::array<float, 3>{}) return Standing::kNothing;
    return corner.confidence > 0 ? Standing::kSeen : Standing::kGuess;
}

/// The whole picture, looked at through three views in the order in which they are asked.
FacePolygon picture_through(const std::array<int, 3>& views) {
    FacePolygon polygon;
    polygon.view_indices = views;
    double weight = 1.0;
    for (Eigen::Vector3d& line : polygon.side_lines) {
        line = {0, 0, weight};
        weight *= kNextWeight;
    }
    return polygon;
}

/// The best that other views can do.
Standing best_standing(const DepthSearch& search) {
    return search.has_depth() ? Standing::kSeen : Standing::kGuess;
}

/// Corners seen by other views.
class OtherCorners {
 public:
    OtherCorners(const PatchSampler& sampler, BlendTriangles& triangles)
        : sampler_(sampler), triangles_(triangles), other_of_(triangles.vertices.size(), kNone) {}

    /// Looked up with all that are wanted, unless it was.
    void want(std::uint32_t corner) {
        if (other_of_[corner] != kNone) return;
        other_of_[corner] = static_cast<std::uint32_t>(other_of_.size() + looked_up_.size());
        looked_up_.push_back(corner);
    }

    void look_up_wanted() {
        const std::size_t known = triangles_.vertices.size();
        const std::size_t done = known - other_of_.size();
        triangles_.vertices.resize(other_of_.size() + looked_up_.size());
        parallel_for_runs(looked_up_.size() - done, kCornersAtATime, 0,
                          [&](std::size_t first, std::size_t end) {
                              for (std::size_t i = first; i < end; ++i)
                                  triangles_.vertices[known + i] =
                                      seen_by_others(triangles_.vertices[looked_up_[done + i]]);
                          });
    }

    [[nodiscard]] std::uint32_t operator[](std::uint32_t corner) const { return other_of_[corner]; }

 private:
    [[nodiscard]] BlendVertex seen_by_others(const BlendVertex& known) const {
        const PatchSample sample =
            sampler_.at({static_cast<double>(known.pixel[0]), static_cast<double>(known.pixel[1])});
        BlendVertex other = blend_vertex(sample, sampler_.polygon(), VertexDepth::kAffine);
        other.face_index = known.face_index;
        other.occluded = known.occluded;
        other.opacity = known.opacity;
        return other;
    }

    const PatchSampler& sampler_;
    BlendTriangles& triangles_;
    std::vector<std::uint32_t> other_of_;   ///< Of the corners that there were at first.
    std::vector<std::uint32_t> looked_up_;  ///< Corners; their others stand behind all of those.
};

/// A triangle that others may show better.
struct Candidate {
    std::size_t first_index;
    std::uint32_t worst_corner;
    Standing standing;  ///< Of this corner.
};

Eigen::Vector2d middle_of(const BlendTriangles& triangles, std::size_t first_index) {
    Eigen::Vector2d sum(0, 0);
    for (std::size_t k = first_index; k < first_index + 3; ++k) {
        const std::array<float, 2>& pixel = triangles.vertices[triangles.indices[k]].pixel;
        sum += Eigen::Vector2d(static_cast<double>(pixel[0]), static_cast<double>(pixel[1]));
    }
    return sum / 3;
}

bool is_in(const PictureStrip& strip, const Eigen::Vector2d& pixel) {
    return pixel.x() >= strip.begin_px && pixel.x() < strip.end_px;
}

std::vector<Candidate> candidates_in(const PictureStrip& strip, const BlendTriangles& triangles,
                                     Standing best) {
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        Candidate candidate{i, 0, best};
        for (std::size_t k = i; k < i + 3; ++k) {
            const Standing standing = standing_of(triangles.vertices[triangles.indices[k]]);
            if (standing >= candidate.standing) continue;
            candidate.worst_corner = triangles.indices[k];
            candidate.standing = standing;
        }
        if (candidate.standing < best && is_in(strip, middle_of(triangles, i)))
            candidates.push_back(candidate);
    }
    return candidates;
}

}  // namespace

std::vector<Eigen::Vector2d> middles_of_unseen(const DepthSearch& search,
                                               const BlendTriangles& triangles) {
    const std::vector<Candidate> unseen = candidates_in({}, triangles, best_standing(search));
    const std::size_t step = (unseen.size() + kMostMiddles - 1) / kMostMiddles;
    std::vector<Eigen::Vector2d> middles;
    for (std::size_t i = 0; i < unseen.size(); i += step)
        middles.push_back(middle_of(triangles, unseen[i].first_index));
    return middles;
}

void draw_unseen_from(const std::array<int, 3>& other_views, const PictureStrip& strip,
                      const DepthSearch& search, const Eigen::Vector3d& scene_plane,
                      const PatchSampler::Options& sampling, BlendTriangles& triangles) {
    const FacePolygon polygon = picture_through(other_views);
    const PatchSampler sampler(polygon, search, scene_plane, sampling);
    std::vector<Candidate> candidates = candidates_in(strip, triangles, best_standing(search));
    OtherCorners others(sampler, triangles);
    const auto corner_of = [&](const Candidate& of, std::size_t k) -> std::uint32_t& {
        return triangles.indices[of.first_index + k];
    };
    const auto is_better = [&](const Candidate& than, std::uint32_t corner) {
        return standing_of(triangles.vertices[others[corner]]) > than.standing;
    };
    for (const Candidate& candidate : candidates) others.want(candidate.worst_corner);
    others.look_up_wanted();
    std::erase_if(candidates, [&](const Candidate& of) { return !is_better(of, of.worst_corner); });
    for (const Candidate& candidate : candidates)
        for (std::size_t k = 0; k < 3; ++k) others.want(corner_of(candidate, k));
    others.look_up_wanted();
    for (const Candidate& candidate : candidates) {
        if (!is_better(candidate, corner_of(candidate, 0)) ||
            !is_better(candidate, corner_of(candidate, 1)) ||
            !is_better(candidate, corner_of(candidate, 2)))
            continue;
        for (std::size_t k = 0; k < 3; ++k)
            corner_of(candidate, k) = others[corner_of(candidate, k)];
    }
}

}  // namespace lumi
