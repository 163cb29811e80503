#pragma once

#include <string>

#include "meshing/surface/depth_map.h"

namespace lumi {

/// What one rung of the ladder says of one view.
struct DepthEstimate {
    DepthMap map;
    std::string model;  ///< Name of the rung that made it.
    /// True when `map.confidence` is a claim that other views must still confirm; false when it is
    /// final.
    bool needs_confirmation = false;
    /// True when the map says something of every pixel, also where its confidence is 0.
    bool is_complete = false;
    /// True when what the map knows is given, not found: it then stays as it is, to the pixel, and
    /// only what is unknown is filled.
    bool is_exact = false;
};

}  // namespace lumi
