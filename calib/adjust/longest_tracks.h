#pragma once

#include <cstddef>
#include <vector>

namespace lumi {

/// Of tracks, each given by the views that see it, the longest, so many that each view has as many
/// as asked or all that it has. Indices into `views_of_track`, the longest first, those of one
/// length in their order.
[[nodiscard]] std::vector<std::size_t> longest_tracks(
    const std::vector<std::vector<int>>& views_of_track, std::size_t views, int tracks_a_view);

}  // namespace lumi
