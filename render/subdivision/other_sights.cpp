#include "render/subdivision/other_sights.h"

#include <algorithm>
#include <cstddef>

namespace lumi {
namespace {

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

using CornersInView = std::array<const BlendVertex*, 3>;

/// Whether the view sees the plane through the corners at the middles of the edges and of the
/// triangle: another surface before it would be drawn on it.
bool sees_between(const CornersInView& corners, const DepthSearch& search, int view) {
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

/// A corner as the view sees it.
BlendVertex as_seen(const BlendVertex& sight, const BlendVertex& known) {
    BlendVertex seen = sight;
    seen.depth = 1 / sight.depth_ratios[0];
    seen.face_index = known.face_index;
    seen.occluded = known.occluded;
    seen.opacity = known.opacity;
    return seen;
}

}  // namespace

Standing standing_of(const BlendVertex& corner) {
    if (corner.weights == std::array<float, 3>{}) return Standing::kNothing;
    return corner.confidence > 0 ? Standing::kSeen : Standing::kGuess;
}

Standing best_standing(const DepthSearch& search) {
    return search.has_depth() ? Standing::kSeen : Standing::kGuess;
}

SightSearch::SightSearch(const AskedViews& asked, const std::vector<BlendVertex>& vertices)
    : asked_(asked), vertices_(vertices), best_(best_standing(asked.search)) {}

const BlendVertex& SightSearch::corner_in(int view, std::uint32_t corner) {
    const auto [sight, is_new] = corners_.try_emplace(key_of(corner, view));
    if (is_new) {
        const FacePolygon picture = picture_through(view);
        const PatchSampler sampler(picture, asked_.search, asked_.scene_plane, asked_.sampling);
        sight->second = blend_vertex(sampler.at(vector_of(vertices_[corner].pixel)), picture,
                                     VertexDepth::kAffine);
    }
    return sight->second;
}

OtherSights SightSearch::sights_of(const UnseenTriangle& triangle) {
    OtherSights result;
    for (const int view : triangle.asked_views) {
        CornersInView corners{};
        for (std::size_t k = 0; k < 3; ++k) corners[k] = &corner_in(view, triangle.corners[k]);
        const auto seen =
            std::count_if(corners.begin(), corners.end(),
                          [&](const BlendVertex* corner) { return standing_of(*corner) >= best_; });
        if (seen > 0) result.partly_seeing.push_back(view);
        if (seen < 3 || !sees_between(corners, asked_.search, view)) continue;
        result.whole = OtherSight{view, {*corners[0], *corners[1], *corners[2]}};
        break;
    }
    return result;
}

TriangleCorners SeenCorners::corners_of(const OtherSight& sight, const TriangleCorners& corners,
                                        const std::vector<BlendVertex>& vertices,
                                        std::vector<BlendVertex>& seen) {
    TriangleCorners numbers{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto next = static_cast<std::uint32_t>(seen.size());
        const auto [number, is_new] = numbers_.try_emplace(key_of(corners[k], sight.view), next);
        if (is_new) seen.push_back(as_seen(sight.corners[k], vertices[corners[k]]));
        numbers[k] = number->second;
    }
    return numbers;
}

}  // namespace lumi
