#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/rigid3.h"
#include "meshing/matching/tile_search.h"

namespace lumi {

/// A view at one level of the resolution pyramid.
struct SweepView {
    Camera camera;
    Rigid3 cam_from_world;
    GrayImage gray;
};

/// Planes uniform in inverse depth: plane p lies at far + p * step.
struct SweepPlanes {
    double far = 0.0;
    double step = 0.0;
    int count = 0;

    [[nodiscard]] double inverse_depth(double plane) const { return far + plane * step; }
    [[nodiscard]] double plane_at(double inverse_depth) const {
        return (inverse_depth - far) / step;
    }
};

/// The planes that one tile of pixels is matched against: `count` of them from `first` on, as they
/// stand at the tile's centre; they slope by `slope` planes per pixel to the right and down.
struct TilePlanes {
    int first = 0;
    int count = 0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
};

/// Matching cost of each pixel at each plane of its tile; 0 fits, kMaxMatchingCost does not.
class CostVolume {
 public:
    /// `tiles`: one per tile of kTileSide x kTileSide pixels, row by row; counts > 0. The costs are
    /// still to be written; they lie in `memory`, which may have held others.
    CostVolume(int width, int height, std::vector<TilePlanes> tiles,
               std::vector<std::uint8_t> memory = {});

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] int max_count() const { return max_count_; }

    [[nodiscard]] const TilePlanes& tile(int x, int y) const { return tiles_[tile_of(x, y)]; }
    /// Where the costs of pixel (x, y) begin: tile(x, y).count of them, nearest plane last.
    [[nodiscard]] std::size_t offset(int x, int y) const {
        const auto in_tile = static_cast<std::size_t>((y % kTileSide) * kTileSide + x % kTileSide);
        const std::size_t tile = tile_of(x, y);
        return offsets_[tile] + in_tile * static_cast<std::size_t>(tiles_[tile].count);
    }
    /// The plane of the sweep that index 0 of pixel (x, y) stands for; whole only without slope.
    [[nodiscard]] double first_plane(int x, int y) const {
        const TilePlanes& planes = tile(x, y);
        const Eigen::Vector2d from_centre(x % kTileSide + 0.5 - 0.5 * kTileSide,
                                          y % kTileSide + 0.5 - 0.5 * kTileSide);
        return planes.first + planes.slope.dot(from_centre);
    }
    [[nodiscard]] std::vector<std::uint8_t>& costs() { return costs_; }
    [[nodiscard]] const std::vector<std::uint8_t>& costs() const { return costs_; }
    /// Mean cost of each pixel over the planes at which some neighbour sees it; 0 without any.
    [[nodiscard]] GrayImage& mean_seen_costs() { return mean_seen_costs_; }
    [[nodiscard]] const GrayImage& mean_seen_costs() const { return mean_seen_costs_; }

 private:
    [[nodiscard]] std::size_t tile_of(int x, int y) const {
        return static_cast<std::size_t>((y / kTileSide) * tiles_along(width_) + x / kTileSide);
    }

    int width_;
    int height_;
    int max_count_ = 0;
    std::vector<TilePlanes> tiles_;
    std::vector<std::size_t> offsets_;
    std::vector<std::uint8_t> costs_;
    GrayImage mean_seen_costs_;
};

constexpr int kMaxMatchingCost = 48;

/// Plane sweep (Collins 1996): for each tile and plane the neighbours are warped onto the view and
/// compared by census, which no change of exposure disturbs; the cost is the sum of the two best
/// neighbours, so that a view from which the pixel is hidden is not asked.
[[nodiscard]] CostVolume sweep_costs(const SweepView& view,
                                     const std::vector<SweepView>& neighbours,
                                     const SweepPlanes& planes, std::vector<TilePlanes> tiles,
                                     std::vector<std::uint8_t> memory = {});

}  // namespace lumi
