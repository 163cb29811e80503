#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace lumi {

/// A two-dimensional array of NumPy, by rows.
struct NpyMatrix {
    std::size_t rows = 0;
    std::size_t columns = 0;
    std::vector<double> values;

    [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
        return values[row * columns + column];
    }
};

/// Reads a .npy file of little-endian 32 or 64 bit floats in C order. Sizes are compared with the
/// bytes that are there before memory is taken. Throws Error (E-IMPORT-NPY). Reference:
/// numpy.org/doc/stable/reference/generated/numpy.lib.format.html.
[[nodiscard]] NpyMatrix read_npy_matrix(const std::filesystem::path& path);

}  // namespace lumi
