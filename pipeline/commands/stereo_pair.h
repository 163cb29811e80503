#pragma once

#include <functional>

#include "render/frame/frame.h"
#include "render/lumigraph/lumigraph.h"

namespace lumi {

using Draw = std::function<Frame(const Eye&)>;

/// One picture; with a baseline, in world units, that of the left eye and that of the right one
/// beside each other, both half of it away from `eye` along its x axis. Their optical axes stay
/// parallel and their pictures are shifted, so that what `eye` sees of the scene's plane
/// (scene_plane.h) in the middle of its picture is there in both: that lies in the screen.
[[nodiscard]] ColorImage picture_of(const Lumigraph& lumigraph, const Eye& eye,
                                    double stereo_baseline, const Draw& draw);

}  // namespace lumi
