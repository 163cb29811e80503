#pragma once

#include <cstddef>
#include <vector>

#include "render/subdivision/other_sights.h"

namespace lumi {

/// How far triangles are divided that other views see in part.
struct SeenPartsOptions {
    double long_edge_px = 24.0;  ///< Triangles with no edge as long are not divided. > 0.
    std::size_t max_parts = 0;   ///< No more, the least divided first; 0: any number.
};

/// What other views see of triangles that no one view sees whole (draw_unseen), as at the border of
/// their photographs or beside an outline. Each is quartered: of its quarters those are drawn that
/// one of the views sees whole that see a corner of it; quarters that are seen in part are
/// quartered again, and so on. To be drawn over the triangles, which border on others and stay as
/// they are. The triangles' corners are indices into `vertices`. The same for any number of
/// threads.
[[nodiscard]] BlendTriangles seen_parts(const std::vector<UnseenTriangle>& partly_seen,
                                        const std::vector<BlendVertex>& vertices,
                                        const AskedViews& asked, const SeenPartsOptions& options);

}  // namespace lumi
