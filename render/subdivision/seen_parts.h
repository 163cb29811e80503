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
/// their photographs or beside an outline: of the four quarters of each, those that one of the
/// views sees whole that see a corner of it; of the others that are seen in part, their quarters;
/// and so on. To be drawn over the triangles, which border on others and stay as they are.
/// `vertices` are those that the triangles' corners are numbers of. The same for any number of
/// threads.
[[nodiscard]] BlendTriangles seen_parts(const std::vector<UnseenTriangle>& partly_seen,
                                        const std::vector<BlendVertex>& vertices,
                                        const AskedViews& asked, const SeenPartsOptions& options);

}  // namespace lumi
