#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "render/subdivision/patch_sampler.h"

namespace lumi {

/// How well a corner's photographs stand for what is there.
enum class Standing { kNothing, kGuess, kSeen };

[[nodiscard]] Standing standing_of(const BlendVertex& corner);

/// The best there is: where there is no depth at all, guesses.
[[nodiscard]] Standing best_standing(const DepthSearch& search);

/// The numbers of a triangle's corners in a list of vertices.
using TriangleCorners = std::array<std::uint32_t, 3>;

/// A triangle that others than its own cameras may show better.
struct UnseenTriangle {
    TriangleCorners corners{};
    std::vector<int> asked_views;  ///< One after the other.
};

/// A triangle as another view sees it.
struct OtherSight {
    int view;
    std::array<BlendVertex, 3> corners;
};

/// What the views that a triangle asks see of it.
struct OtherSights {
    std::optional<OtherSight> whole;  ///< Of the first view that sees all of it.
    std::vector<int> partly_seeing;   ///< Those asked until then that see a corner.
};

/// How views are asked.
struct AskedViews {
    const DepthSearch& search;
    const Eigen::Vector3d& scene_plane;
    const PatchSampler::Options& sampling;
};

/// Asks views for triangles. What a view sees at a corner is looked up once, however many triangles
/// share it.
class SightSearch {
 public:
    /// The corners of triangles are numbers of `vertices`, of which only the pixels count, and
    /// which may become more.
    SightSearch(const AskedViews& asked, const std::vector<BlendVertex>& vertices);

    /// What its `asked_views` see of the triangle, one asked after the other until one sees all of
    /// it: the corners stand as well as they can there, and nothing stands before the plane through
    /// them in between.
    [[nodiscard]] OtherSights sights_of(const UnseenTriangle& triangle);

 private:
    [[nodiscard]] const BlendVertex& corner_in(int view, std::uint32_t corner);

    AskedViews asked_;
    const std::vector<BlendVertex>& vertices_;
    Standing best_;
    std::unordered_map<std::uint64_t, BlendVertex> corners_;
};

/// Corners as other views see them, each of them one vertex however many triangles share it.
class SeenCorners {
 public:
    /// The numbers of the three that a view sees, appended to `seen` where they are new. What no
    /// view tells, as the face, they have from the `corners` among `vertices` that they stand for;
    /// `seen` may be the same list.
    TriangleCorners corners_of(const OtherSight& sight, const TriangleCorners& corners,
                               const std::vector<BlendVertex>& vertices,
                               std::vector<BlendVertex>& seen);

 private:
    std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

}  // namespace lumi
