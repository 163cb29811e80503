#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/subdivision/other_sights.h"
#include "render/subdivision/patch_sampler.h"

namespace lumi {

/// Draws from other views what a face's cameras do not see.
///
/// A triangle with a corner that none of its cameras sees, because something hides it or because it
/// lies beyond their photographs, is looked up in the nearest of the other views (nearest_views.h),
/// and if that does not see it, in the next, up to six. It gets the photograph of the first of them
/// that sees all of its corners, and the plane through them in between: what is looked up at a
/// guess can be anything, and so can what hides the triangle from a photograph.
/// Where there is no depth at all, guesses are all there is, and better than nothing. Other
/// triangles stay as they are. The same for any number of threads.
///
/// Returns the triangles that stay as they are although some of these views see corners of them, as
/// indices into `triangles.vertices`; these views are then the ones to be asked for parts
/// (seen_parts.h).
std::vector<UnseenTriangle> draw_unseen(const Lumigraph& lumigraph, const Eye& eye,
                                        const DepthSearch& search,
                                        const Eigen::Vector3d& scene_plane,
                                        const PatchSampler::Options& sampling,
                                        BlendTriangles& triangles);

}  // namespace lumi
