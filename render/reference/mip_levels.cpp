#include "render/reference/mip_levels.h"

#include <algorithm>
#include <cmath>

namespace lumi {

MipLevels::MipLevels(std::vector<unsigned char> rgba, int width_px, int height_px) {
    levels_.push_back({std::move(rgba), width_px, height_px});
    while (levels_.back().width_px > 1 || levels_.back().height_px > 1) {
        const Level& finer = levels_.back();
        Level level{{}, std::max(1, finer.width_px / 2), std::max(1, finer.height_px / 2)};
        for (int y = 0; y < level.height_px; ++y) {
            for (int x = 0; x < level.width_px; ++x) {
                const Eigen::Vector4d texel =
                    finer.at({(x + 0.5) / level.width_px, (y + 0.5) / level.height_px});
                for (Eigen::Index i = 0; i < 4; ++i)
                    level.rgba.push_back(static_cast<unsigned char>(std::lround(texel[i])));
            }
        }
        levels_.push_back(std::move(level));
    }
    for (std::size_t i = 1; i < levels_.size(); ++i) levels_[i].end_at_borders();
}

void MipLevels::Level::end_at_borders() {
    for (int y = 0; y < height_px; ++y)
        for (int x = 0; x < width_px; ++x)
            if (x == 0 || y == 0 || x == width_px - 1 || y == height_px - 1)
                rgba[4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px) +
                          static_cast<std::size_t>(x)) +
                     3] = 0;
}

Eigen::Vector4d MipLevels::at(const Eigen::Vector2d& place, double lod) const {
    const double clamped = std::clamp(lod, 0.0, static_cast<double>(levels_.size() - 1));
    const auto finer = static_cast<std::size_t>(clamped);
    const std::size_t coarser = std::min(finer + 1, levels_.size() - 1);
    const double share = clamped - static_cast<double>(finer);
    return (1 - share) * levels_[finer].at(place) + share * levels_[coarser].at(place);
}

Eigen::Vector4d MipLevels::Level::at(const Eigen::Vector2d& place) const {
    const double x = std::clamp(place.x() * width_px - 0.5, 0.0, width_px - 1.0);
    const double y = std::clamp(place.y() * height_px - 0.5, 0.0, height_px - 1.0);
    const int left = static_cast<int>(x);
    const int top = static_cast<int>(y);
    const auto texel = [&](int column, int row) {
        const std::size_t first = 4 * (static_cast<std::size_t>(std::min(row, height_px - 1)) *
                                           static_cast<std::size_t>(width_px) +
                                       static_cast<std::size_t>(std::min(column, width_px - 1)));
        return Eigen::Vector4d(rgba[first], rgba[first + 1], rgba[first + 2], rgba[first + 3]);
    };
    const double right = x - left;
    const double down = y - top;
    return (1 - down) * ((1 - right) * texel(left, top) + right * texel(left + 1, top)) +
           down * ((1 - right) * texel(left, top + 1) + right * texel(left + 1, top + 1));
}

}  // namespace lumi
