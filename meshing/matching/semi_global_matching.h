#pragma once

#include <cstdint>
#include <vector>

#include "calib/capture/image.h"
#include "meshing/matching/cost_volume.h"

namespace lumi {

/// Price of a depth that differs from the neighbouring pixel's.
struct SmoothnessPenalty {
    int one_plane = 4;        ///< P1: by one plane, as on a slanted surface.
    int jump = 90;            ///< P2: by more, where the photograph has no edge.
    int jump_at_edge = 24;    ///< P2 where grey changes strongly; >= one_plane.
    double edge_gray = 12.0;  ///< Grey difference at which P2 has fallen by two thirds.
};

struct MatchedPlanes {
    FloatImage plane;  ///< In planes of the sweep, with the parabola's fraction.
    GrayImage cost;    ///< Matching cost of the chosen plane.
};

/// Semi-global matching (Hirschmueller 2008): eight paths, P2 lowered at edges of the photograph,
/// the winner refined by a parabola through its two neighbours. Ranges may differ from tile to
/// tile; a plane outside the previous pixel's range is reached by a jump. `sums` is memory for the
/// work (aggregate_paths), which may have held other sums.
[[nodiscard]] MatchedPlanes semi_global_matching(const CostVolume& volume, const GrayImage& gray,
                                                 const SmoothnessPenalty& penalty,
                                                 std::vector<std::uint16_t>& sums);

/// Writes the sums over the paths from which the winner is taken into `sums`, in the layout of the
/// volume's costs.
void aggregate_paths(const CostVolume& volume, const GrayImage& gray,
                     const SmoothnessPenalty& penalty, std::vector<std::uint16_t>& sums);

}  // namespace lumi
