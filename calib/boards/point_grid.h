#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace lumi {

/// Points of a picture in square buckets, to find neighbours quickly.
class PointGrid {
 public:
    /// Keeps a copy of the points; the buckets are sized for a few points each.
    explicit PointGrid(std::vector<Eigen::Vector2d> points_px);

    [[nodiscard]] const std::vector<Eigen::Vector2d>& points_px() const { return points_px_; }
    /// Indices of the points within `radius_px` of `where_px`, nearest first.
    [[nodiscard]] std::vector<std::size_t> within(const Eigen::Vector2d& where_px,
                                                  double radius_px) const;
    /// Indices of the `count` points nearest to point `index`, without itself, nearest first.
    [[nodiscard]] std::vector<std::size_t> neighbours(std::size_t index, std::size_t count) const;

 private:
    [[nodiscard]] std::size_t bucket_of(int column, int row) const;

    std::vector<Eigen::Vector2d> points_px_;
    Eigen::Vector2d corner_px_ = Eigen::Vector2d::Zero();
    double bucket_px_ = 1.0;
    int columns_ = 1;
    int rows_ = 1;
    std::vector<std::vector<std::size_t>> buckets_;
};

}  // namespace lumi
