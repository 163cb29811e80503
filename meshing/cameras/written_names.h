#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>
#include <vector>

namespace lumi {

/// Where names stand in a picture: of two over one another neither can be read.
class WrittenNames {
 public:
    /// Of letters of that size, in units of the picture.
    explicit WrittenNames(double letter_size) : letter_size_(letter_size) {}

    /// True where a name whose first letter stands at `at` meets none that was written; then it
    /// counts as written.
    [[nodiscard]] bool claim(const Eigen::Vector2d& at, const std::string& name);

 private:
    double letter_size_;
    std::vector<Eigen::AlignedBox2d> boxes_;
};

}  // namespace lumi
