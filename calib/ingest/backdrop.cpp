#include "calib/ingest/backdrop.h"

#include <vector>

#include "calib/work/median.h"

namespace lumi {

std::optional<LevelRange> backdrop_levels(const StandingPixels& standing,
                                          const ImageRectangle& picture) {
    constexpr double kMost = 0.5;
    constexpr double kStraysShare = 0.05;
    std::vector<double> levels;
    int border_px = 0;
    const auto look_at = [&](int x, int y) {
        ++border_px;
        if (standing.spread(x, y) <= kStillSpread) levels.push_back(standing.mean(x, y));
    };
    const int right = picture.left + picture.width_px - 1;
    const int bottom = picture.top + picture.height_px - 1;
    for (int x = picture.left; x <= right; ++x) {
        look_at(x, picture.top);
        look_at(x, bottom);
    }
    for (int y = picture.top; y <= bottom; ++y) {
        look_at(picture.left, y);
        look_at(right, y);
    }
    if (static_cast<double>(levels.size()) < kMost * border_px) return std::nullopt;
    return LevelRange{quantile_of(levels, kStraysShare), quantile_of(levels, 1 - kStraysShare)};
}

}  // namespace lumi
