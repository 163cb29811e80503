#include "calib/features/nearest_kernel_loops.h"

namespace lumi {
namespace {

/// Four columns at once, in plain C++.
struct PortableLanes {
    static constexpr std::size_t kLanes = 4;
    static constexpr std::size_t kRows = 2;
    static constexpr std::size_t kGroups = 1;
    static constexpr std::size_t kValuesPerWord = 2;
    static constexpr bool kRowsAreSigned = false;
    struct Vector {
        std::uint32_t lane[kLanes];
    };

    static Vector load(const std::uint32_t* from) { return {{from[0], from[1], from[2], from[3]}}; }
    static void store(std::uint32_t* to, const Vector& value) {
        for (std::size_t i = 0; i < kLanes; ++i) to[i] = value.lane[i];
    }
    static Vector all(std::uint32_t value) { return {{value, value, value, value}}; }
    static Vector multiply_add(Vector sum, const Vector& row, const Vector& column) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            sum.lane[i] += (row.lane[i] & 0xffffU) * (column.lane[i] & 0xffffU) +
                           (row.lane[i] >> 16U) * (column.lane[i] >> 16U);
        }
        return sum;
    }
    static Vector shifted(Vector value) {
        for (std::uint32_t& lane : value.lane) lane <<= kNearestIndexBits;
        return value;
    }
    static Vector either(Vector a, const Vector& b) {
        for (std::size_t i = 0; i < kLanes; ++i) a.lane[i] |= b.lane[i];
        return a;
    }
    static Vector larger(Vector a, const Vector& b) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            a.lane[i] = a.lane[i] > b.lane[i] ? a.lane[i] : b.lane[i];
        }
        return a;
    }
    static Vector smaller(Vector a, const Vector& b) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            a.lane[i] = a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i];
        }
        return a;
    }
};

}  // namespace

NearestKernel portable_nearest_kernel() { return kernel_of<PortableLanes>(); }

}  // namespace lumi
