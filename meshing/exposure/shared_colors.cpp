#include "meshing/exposure/shared_colors.h"

#include <cmath>

#include "meshing/warp/warped_rows.h"

namespace lumi {

std::vector<SharedColor> shared_colors(const ShownDepth& own, const ShownDepth& other,
                                       const InverseDepthWarp& own_from_other, float tolerance,
                                       int step) {
    std::vector<SharedColor> shared;
    const WarpRaster raster{own.picture.width(), own.picture.height(), 0, 0};
    warp_rows(other.known, own_from_other, raster, step, [&](int y, const WarpedRow& warped) {
        for (std::size_t i = 0; i < warped.rows.size(); i += static_cast<std::size_t>(step)) {
            if (warped.rows[i] < 0) continue;
            const int column = warped.columns[i];
            const int row = warped.rows[i];
            if (own.known.confidence(column, row) == 0) continue;
            const float apart = own.known.inverse_depth(column, row) - warped.inverse_depths[i];
            if (std::abs(apart) > tolerance) continue;
            shared.push_back({own.picture(column, row), other.picture(static_cast<int>(i), y)});
        }
    });
    return shared;
}

}  // namespace lumi
