#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "render/modes/subdivision.h"

namespace lumi {

/// The middles of triangles that other views may show better: without depth anywhere, only of those
/// that show nothing. No more than kMostMiddles, spread over them.
[[nodiscard]] std::vector<Eigen::Vector2d> middles_of_unseen(const DepthSearch& search,
                                                             const BlendTriangles& triangles);
inline constexpr std::size_t kMostMiddles = 64;

/// Columns of the eye's picture, from one to before the other; all of them.
struct PictureStrip {
    double begin_px = std::numeric_limits<double>::lowest();
    double end_px = std::numeric_limits<double>::max();
};

/// Draws what a face's cameras do not see from others, of the triangles whose middle lies in the
/// strip.
///
/// A triangle with a corner that none of its cameras sees, because something hides it or because it
/// lies beyond their photographs, gets `other_views` instead, the first of them that sees a corner
/// there, if these see all of its corners, or show them where its own have nothing. Corners are
/// looked up anew, once each; those of neighbours stay as they are. The same for any number of
/// threads.
void draw_unseen_from(const std::array<int, 3>& other_views, const PictureStrip& strip,
                      const DepthSearch& search, const Eigen::Vector3d& scene_plane,
                      const PatchSampler::Options& sampling, BlendTriangles& triangles);

}  // namespace lumi
