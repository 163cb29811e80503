#include "calib/boards/point_grid.h"

#include <algorithm>
#include <cmath>

namespace lumi {

PointGrid::PointGrid(std::vector<Eigen::Vector2d> points_px) : points_px_(std::move(points_px)) {
    if (!points_px_.empty()) {
        corner_px_ = points_px_.front();
        Eigen::Vector2d opposite_px = corner_px_;
        for (const Eigen::Vector2d& point_px : points_px_) {
            corner_px_ = corner_px_.cwiseMin(point_px);
            opposite_px = opposite_px.cwiseMax(point_px);
        }
        const Eigen::Vector2d extent_px =
            (opposite_px - corner_px_).cwiseMax(Eigen::Vector2d::Ones());
        constexpr double kPointsPerBucket = 3.0;
        bucket_px_ = std::max(1.0, std::sqrt(extent_px.prod() * kPointsPerBucket /
                                             static_cast<double>(points_px_.size())));
        columns_ = static_cast<int>(extent_px.x() / bucket_px_) + 1;
        rows_ = static_cast<int>(extent_px.y() / bucket_px_) + 1;
    }
    buckets_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::size_t index = 0; index < points_px_.size(); ++index) {
        const Eigen::Vector2d at = (points_px_[index] - corner_px_) / bucket_px_;
        buckets_[bucket_of(static_cast<int>(at.x()), static_cast<int>(at.y()))].push_back(index);
    }
}

std::size_t PointGrid::bucket_of(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
}

std::vector<std::size_t> PointGrid::within(const Eigen::Vector2d& where_px,
                                           double radius_px) const {
    std::vector<std::size_t> found;
    if (!where_px.allFinite()) return found;
    const auto bucket = [&](double offset_px, int last) {
        return static_cast<int>(
            std::floor(std::clamp(offset_px / bucket_px_, -1.0, static_cast<double>(last) + 1.0)));
    };
    const Eigen::Vector2d offset_px = where_px - corner_px_;
    const int first_column = std::max(0, bucket(offset_px.x() - radius_px, columns_));
    const int last_column = std::min(columns_ - 1, bucket(offset_px.x() + radius_px, columns_));
    const int first_row = std::max(0, bucket(offset_px.y() - radius_px, rows_));
    const int last_row = std::min(rows_ - 1, bucket(offset_px.y() + radius_px, rows_));
    for (int row = first_row; row <= last_row; ++row) {
        for (int column = first_column; column <= last_column; ++column) {
            for (const std::size_t index : buckets_[bucket_of(column, row)]) {
                if ((points_px_[index] - where_px).norm() <= radius_px) found.push_back(index);
            }
        }
    }
    std::sort(found.begin(), found.end(), [&](std::size_t a, std::size_t b) {
        const double to_a = (points_px_[a] - where_px).squaredNorm();
        const double to_b = (points_px_[b] - where_px).squaredNorm();
        return to_a < to_b || (to_a == to_b && a < b);
    });
    return found;
}

std::vector<std::size_t> PointGrid::neighbours(std::size_t index, std::size_t count) const {
    const std::size_t wanted = std::min(count + 1, points_px_.size());
    const double reach_px = bucket_px_ * (columns_ + rows_);
    std::vector<std::size_t> found;
    for (double radius_px = bucket_px_; found.size() < wanted; radius_px *= 2) {
        found = within(points_px_[index], radius_px);
        if (radius_px > reach_px) break;
    }
    std::erase(found, index);
    if (found.size() > count) found.resize(count);
    return found;
}

}  // namespace lumi
