#pragma once

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

struct SyntheticAperture {
    /// In world units. A ray is blended from the cameras that it passes within half of it.
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
/// over the paper's disc. Where fewer than three cameras that show the point are within, it is as
/// wide as the fourth nearest is away, or endless where there is none. Cameras stand anywhere and
/// need span no plane; what stands beyond the point, and sees it from behind, has no weight.
[[nodiscard]] Frame draw_dynamically_reparameterized(const Lumigraph& lumigraph, const Eye& eye,
                                                     const SyntheticAperture& aperture);

/// Twice the typical distance from a camera to the next (parallax.h): some seven cameras of an even
/// grid are within. 0 where all stand in one place.
[[nodiscard]] double usual_aperture_diameter(const Lumigraph& lumigraph);

}  // namespace lumi
