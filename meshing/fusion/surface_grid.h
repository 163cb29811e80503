#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "calib/capture/image.h"
#include "meshing/fusion/surface_points.h"

namespace lumi {

/// One pixel's place on the surface, in the world of the poses.
struct SurfaceSample {
    Eigen::Vector3d position;
    Eigen::Vector3d normal;
    Rgb8 color;
    double weight = 0.0;
};

/// How fine one view sees.
struct Acuity {
    Eigen::Vector3d centre_in_world;
    double focal_length_px = 0.0;
    double baseline = 0.0;  ///< To the farthest of its neighbours, world units.

    /// Of a cell at this place: some pixels wide, but as deep as a quarter of a pixel of disparity.
    [[nodiscard]] double cell_size(const Eigen::Vector3d& place, double spacing_px) const;
};

/// A grid in space whose cells are as large as the view that sees them finest wants them; their
/// sizes are powers of two. Samples in one cell are averaged.
class SurfaceGrid {
 public:
    SurfaceGrid(std::vector<Acuity> views, double spacing_px);

    void add(const SurfaceSample& sample);
    [[nodiscard]] std::size_t size() const { return cells_.size(); }

    /// The means of the cells, in an order that depends on nothing but the points. One pixel alone
    /// in its cell is an outlier; normals that cancel out belong to two sides: neither counts.
    [[nodiscard]] std::vector<SurfacePoint> points() const;

 private:
    struct Cell {
        Eigen::Vector3d position = Eigen::Vector3d::Zero();
        Eigen::Vector3f normal = Eigen::Vector3f::Zero();
        Eigen::Vector3f color = Eigen::Vector3f::Zero();
        double weight = 0.0;
        float size = 0.0F;  ///< World units.
        int samples = 0;
    };
    using Key = std::array<std::int64_t, 4>;  ///< Level and place.
    struct KeyHash {
        std::size_t operator()(const Key& key) const;
    };

    double spacing_px_;
    std::vector<Acuity> views_;
    std::unordered_map<Key, Cell, KeyHash> cells_;
};

}  // namespace lumi
