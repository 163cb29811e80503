#pragma once

#include <cstdint>
#include <vector>

#include "calib/work/progress.h"
#include "meshing/surface/pictured_view.h"

namespace lumi {

/// A view as it would be without its transients (transients.h).
struct ViewWithoutTransients {
    int view = 0;
    double share = 0.0;  ///< Of its picture that was painted over.
    ColorImage photograph;
    DepthMap depth;
};

/// Paints over what was there for one photograph alone: in the colours of the three nearest views
/// that see what lies behind it (their median, in the view's own exposure), and with that depth, as
/// one neighbour confirms it. What no such view sees is painted from its rim (Telea 2004). Views
/// without transients are not listed. As many views are painted at one time as `threads` allow and
/// as take no more than `max_bytes`, nor than the machine can still give; at least one.
[[nodiscard]] std::vector<ViewWithoutTransients> without_transients(
    const std::vector<PicturedView>& views, int threads, std::uint64_t max_bytes,
    Progress& progress);

}  // namespace lumi
