#pragma once

#include "render/lumigraph/lumigraph.h"

namespace lumi {

/// The eye moved along its line of sight by this share of its distance to the scene plane
/// (scene_plane.h) there: towards the scene, or away from it where the share is negative. One that
/// looks past that plane stays.
[[nodiscard]] Eye moved_ahead(const Lumigraph& lumigraph, Eye eye, double share_of_distance);

}  // namespace lumi
