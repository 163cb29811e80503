#pragma once

#include <Eigen/Core>
#include <bit>
#include <cfloat>
#include <cstdint>
#include <string>

#include "calib/work/whole_file.h"

namespace lumi {

static_assert(std::endian::native == std::endian::little, "PLY is written little-endian");

/// Appends a value's bytes to a binary PLY file.
template <class Value>
void append_to_ply(const Value& value, Bytes& bytes) {
    const auto* begin = reinterpret_cast<const std::uint8_t*>(&value);
    bytes.insert(bytes.end(), begin, begin + sizeof(Value));
}

/// How a binary PLY file holds places: as floats, or as doubles where floats would round them by
/// more than a thousandth of the spacing between them, which is far from the world's origin.
class PlyPlaces {
 public:
    /// Both lengths may be sums or typical values over the same places.
    PlyPlaces(double distance_from_origin, double spacing) {
        constexpr double kHeldShare = 1e-3;
        constexpr double kRoundingShare = 0.5 * static_cast<double>(FLT_EPSILON);
        are_floats_ = kRoundingShare * distance_from_origin <= kHeldShare * spacing;
    }

    /// The lines of the header that declare x, y and z.
    [[nodiscard]] std::string properties() const {
        const std::string property = are_floats_ ? "property float " : "property double ";
        return property + "x\n" + property + "y\n" + property + "z\n";
    }
    void append(const Eigen::Vector3d& place, Bytes& bytes) const {
        for (const double coordinate : place) {
            if (are_floats_) {
                append_to_ply(static_cast<float>(coordinate), bytes);
            } else {
                append_to_ply(coordinate, bytes);
            }
        }
    }

 private:
    bool are_floats_ = true;
};

}  // namespace lumi
