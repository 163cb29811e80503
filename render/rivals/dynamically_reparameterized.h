#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

struct SyntheticAperture {
    /// In world units. A ray is blended from the cameras that it passes within half of it, or of
    /// more where these are few.
    double diameter = 0.0;
    FocalPlane focal_plane{};  ///< What is sharp; where there is none, the scene plane.
    int threads = 0;           ///< 0: all cores.
};

/// Dynamically reparameterized light fields (Isaksen, McMillan and Gortler, SIGGRAPH 2000) in plain
/// code: no depth, but a focal plane on which photographs are looked up, and an aperture as wide as
/// several cameras stand apart. What lies off the plane blurs, and what stands before it is seen
/// through, the more the wider the aperture.
///
/// A camera's weight falls linearly from 1 on the ray to 0 at half of the diameter from it: a cone
/// over the paper's disc. Where cameras are sparse the cone is wider, until the weights of those
/// that show the point sum to that of one on the ray (cone_of_cameras.h), or endless where they
/// cannot. Cameras stand anywhere and need span no plane; what stands beyond the point, and sees it
/// from behind, has no weight. Photographs fade in from their borders, so that nothing jumps there,
/// and are looked up at a mip level from far away, as in lumi's own modes.
[[nodiscard]] Frame draw_dynamically_reparameterized(const Lumigraph& lumigraph, const Eye& eye,
                                                     const SyntheticAperture& aperture);

/// Four times the typical distance from a camera to the next (parallax.h): some twelve cameras of
/// an even grid are within. 0 where all stand in one place.
[[nodiscard]] double usual_aperture_diameter(const Lumigraph& lumigraph);

}  // namespace lumi
