#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "calib/capture/camera.h"
#include "calib/capture/image.h"
#include "calib/capture/rigid3.h"
#include "meshing/depth/depth_scene.h"

namespace lumi {

/// A view at one level of the resolution pyramid.
struct SweepView {
    Camera camera;
    Rigid3 cam_from_world;
    GrayImage gray;
};

/// Planes parallel to the picture, uniform in inverse depth: plane p lies at far + p * step.
struct SweepPlanes {
    double far = 0.0;
    double step = 0.0;
    int count = 0;

    [[nodiscard]] double inverse_depth(double plane) const { return far + plane * step; }
    [[nodiscard]] double plane_at(double inverse_depth) const {
        return (inverse_depth - far) / step;
    }
};

/// The planes that one tile of pixels is matched against.
struct PlaneRange {
    int first = 0;
    int count = 0;
    friend bool operator==(const PlaneRange&, const PlaneRange&) = default;
};

/// Matching cost of each pixel at each plane of its tile's range; 0 fits, kMaxMatchingCost does
/// not.
class CostVolume {
 public:
    static constexpr int kTile = 16;

    /// `ranges`: one per tile of kTile x kTile pixels, row by row; counts > 0.
    CostVolume(int width, int height, std::vector<PlaneRange> ranges);

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] int tiles_across() const { return tiles_across_; }
    [[nodiscard]] int tiles_down() const { return tiles_down_; }
    [[nodiscard]] int max_count() const { return max_count_; }

    [[nodiscard]] PlaneRange range(int x, int y) const { return ranges_[tile_of(x, y)]; }
    /// Where the costs of pixel (x, y) begin: range(x, y).count of them, nearest plane last.
    [[nodiscard]] std::size_t offset(int x, int y) const {
        const std::size_t tile = tile_of(x, y);
        const auto in_tile = static_cast<std::size_t>((y % kTile) * kTile + x % kTile);
        return offsets_[tile] + in_tile * static_cast<std::size_t>(ranges_[tile].count);
    }
    [[nodiscard]] std::vector<std::uint8_t>& costs() { return costs_; }
    [[nodiscard]] const std::vector<std::uint8_t>& costs() const { return costs_; }

 private:
    [[nodiscard]] std::size_t tile_of(int x, int y) const {
        return static_cast<std::size_t>((y / kTile) * tiles_across_ + x / kTile);
    }

    int width_;
    int height_;
    int tiles_across_;
    int tiles_down_;
    int max_count_ = 0;
    std::vector<PlaneRange> ranges_;
    std::vector<std::size_t> offsets_;
    std::vector<std::uint8_t> costs_;
};

constexpr int kMaxMatchingCost = 48;

/// Number of tiles that a picture of this size has.
[[nodiscard]] int tile_count(int width, int height);

/// Plane sweep (Collins 1996): for each tile and plane the neighbours are warped onto the view and
/// compared by census, which no change of exposure disturbs; the cost is the sum of the two best
/// neighbours, so that a view from which the pixel is hidden is not asked.
[[nodiscard]] CostVolume sweep_costs(const SweepView& view,
                                     const std::vector<SweepView>& neighbours,
                                     const SweepPlanes& planes, std::vector<PlaneRange> ranges);

}  // namespace lumi
