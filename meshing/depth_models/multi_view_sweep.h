#pragma once

#include <cstdint>
#include <mutex>
#include <vector>

#include "meshing/depth_scene/depth_scene.h"
#include "meshing/surface/depth_map.h"

namespace lumi {

/// What one sweep works in, to be used again by the next: fresh pages would take a fifth of its
/// time.
struct SweepMemory {
    std::vector<std::uint8_t> costs;
    std::vector<std::uint16_t> sums;
};

/// Memory for as many sweeps as run at one time.
class SweepMemoryPool {
 public:
    [[nodiscard]] SweepMemory take();
    void give_back(SweepMemory memory);

 private:
    std::mutex mutex_;
    std::vector<SweepMemory> spare_;
};

/// Depth of one view by plane sweep and semi-global matching against its neighbours, from coarse
/// to fine: the coarsest picture searches the whole range, each finer one what the coarser one
/// found in and around a tile (SURE, Rothermel et al. 2012). Planes stand one pixel of disparity
/// apart in the fastest-moving neighbour, three quarters of one on the finest level.
///
/// Confidence is kKnown where the photographs tell one depth from another and kUnseen where any
/// would do; whether other views agree is not asked here. Memory: 3 bytes for each of so many costs
/// as sweep_cells_allowed (sweep_search.h) says; where more are needed, less is searched.
[[nodiscard]] DepthMap multi_view_sweep(const DepthScene& scene, int view_index,
                                        SweepMemory& memory);

}  // namespace lumi
