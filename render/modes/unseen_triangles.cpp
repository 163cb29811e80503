#include "render/modes/unseen_triangles.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumi {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;
/// The weight of the next view beside one that sees the point: it counts where that does not.
constexpr double kNextWeight = 1e-3;

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

/// The same corners seen by other views, looked up when they are asked for.
class OtherCorners {
 public:
    OtherCorners(const PatchSampler& sampler, BlendTriangles& triangles)
        : sampler_(sampler), triangles_(triangles), other_of_(triangles.vertices.size(), kNone) {}

    std::uint32_t other_of(std::uint32_t corner) {
        if (other_of_[corner] == kNone) {
            const BlendVertex& known = triangles_.vertices[corner];
            const PatchSample sample = sampler_.at(
                {static_cast<double>(known.pixel[0]), static_cast<double>(known.pixel[1])});
            BlendVertex other = blend_vertex(sample, sampler_.polygon(), VertexDepth::kAffine);
            other.face_index = known.face_index;
            other.occluded = known.occluded;
            other.opacity = known.opacity;
            other_of_[corner] = static_cast<std::uint32_t>(triangles_.vertices.size());
            triangles_.vertices.push_back(other);
        }
        return other_of_[corner];
    }

 private:
    const PatchSampler& sampler_;
    BlendTriangles& triangles_;
    std::vector<std::uint32_t> other_of_;
};

}  // namespace

void draw_unseen_from(const std::array<int, 3>& other_views, const DepthSearch& search,
                      const Eigen::Vector3d& scene_plane, const PatchSampler::Options& sampling,
                      BlendTriangles& triangles) {
    const FacePolygon polygon = picture_through(other_views);
    const PatchSampler sampler(polygon, search, scene_plane, sampling);
    OtherCorners corners(sampler, triangles);
    const auto least_standing = [&](const std::array<std::uint32_t, 3>& of) {
        return std::min({standing_of(triangles.vertices[of[0]]),
                         standing_of(triangles.vertices[of[1]]),
                         standing_of(triangles.vertices[of[2]])});
    };
    for (std::size_t i = 0; i < triangles.indices.size(); i += 3) {
        const std::array<std::uint32_t, 3> own{triangles.indices[i], triangles.indices[i + 1],
                                               triangles.indices[i + 2]};
        const Standing standing = least_standing(own);
        if (standing == Standing::kSeen) continue;
        const std::array<std::uint32_t, 3> others{
            corners.other_of(own[0]), corners.other_of(own[1]), corners.other_of(own[2])};
        if (least_standing(others) <= standing) continue;
        std::copy(others.begin(), others.end(),
                  triangles.indices.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

}  // namespace lumi
