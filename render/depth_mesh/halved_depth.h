#pragma once

#include "meshing/surface/depth_map.h"

namespace lumi {

/// A depth map of half as many rows and columns. Of four samples those of the more frequent
/// confidence count (seen, where there are two each); where the widest gap between their inverse
/// depths is more than `max_gap`, only those on its more numerous side (the nearer, where there are
/// as many). They are averaged: surfaces are not mixed, and noise is halved. At least one by one.
[[nodiscard]] DepthMap halved(const DepthMap& depth, double max_gap);

}  // namespace lumi
