#pragma once

#include "calib/features/nearest_kernel.h"

/// The loops that all kernels share, compiled anew in each file that includes this, for that file's
/// instruction set. No function of the standard library may be called in here: the linker would
/// keep one copy of it for the whole program, perhaps the one with instructions that the machine
/// does not have.
namespace lumi {
namespace {

/// Keeps the two larger of three words.
template <class Lanes>
inline void offer(typename Lanes::Vector candidate, std::uint32_t* best, std::uint32_t* second) {
    const typename Lanes::Vector was_best = Lanes::load(best);
    Lanes::store(second, Lanes::larger(Lanes::load(second), Lanes::smaller(was_best, candidate)));
    Lanes::store(best, Lanes::larger(was_best, candidate));
}

/// kRows x kGroups sums at once, all in registers.
template <class Lanes>
inline void compare_step(const NearestBlock& block, std::size_t first_row,
                         std::size_t first_group) {
    using Vector = typename Lanes::Vector;
    constexpr std::size_t kWords = kDescriptorSize / Lanes::kValuesPerWord;
    constexpr std::size_t kLanes = Lanes::kLanes;
    const std::uint32_t* const rows = block.row_words + first_row * kWords;
    const std::uint32_t* const columns = block.column_words + first_group * kWords * kLanes;
    Vector sum[Lanes::kRows][Lanes::kGroups];
#pragma GCC unroll 16
    for (std::size_t group = 0; group < Lanes::kGroups; ++group) {
        const Vector start = Lanes::load(block.column_starts + (first_group + group) * kLanes);
#pragma GCC unroll 16
        for (std::size_t row = 0; row < Lanes::kRows; ++row) sum[row][group] = start;
    }
#pragma GCC unroll 1
    for (std::size_t word = 0; word < kWords; ++word) {
        Vector column[Lanes::kGroups];
#pragma GCC unroll 16
        for (std::size_t group = 0; group < Lanes::kGroups; ++group) {
            column[group] = Lanes::load(columns + (group * kWords + word) * kLanes);
        }
#pragma GCC unroll 16
        for (std::size_t row = 0; row < Lanes::kRows; ++row) {
            const Vector value = Lanes::all(rows[row * kWords + word]);
#pragma GCC unroll 16
            for (std::size_t group = 0; group < Lanes::kGroups; ++group) {
                sum[row][group] = Lanes::multiply_add(sum[row][group], value, column[group]);
            }
        }
    }
#pragma GCC unroll 16
    for (std::size_t group = 0; group < Lanes::kGroups; ++group) {
        const std::size_t at_group = first_group + group;
        const Vector group_code =
            Lanes::all(kNearestIndexMask - static_cast<std::uint32_t>(at_group));
        std::uint32_t* const column_best = block.column_best + at_group * kLanes;
        std::uint32_t* const column_second = block.column_second + at_group * kLanes;
        Vector best = Lanes::load(column_best);
        Vector second = Lanes::load(column_second);
#pragma GCC unroll 16
        for (std::size_t row = 0; row < Lanes::kRows; ++row) {
            const std::size_t at_row = first_row + row;
            const Vector shifted = Lanes::shifted(sum[row][group]);
            offer<Lanes>(Lanes::either(shifted, group_code), block.row_best + at_row * kLanes,
                         block.row_second + at_row * kLanes);
            const Vector in_column = Lanes::either(
                shifted, Lanes::all(kNearestIndexMask - static_cast<std::uint32_t>(at_row)));
            second = Lanes::larger(second, Lanes::smaller(best, in_column));
            best = Lanes::larger(best, in_column);
        }
        Lanes::store(column_best, best);
        Lanes::store(column_second, second);
    }
}

template <class Lanes>
void compare_block(const NearestBlock& block) {
    for (std::size_t row = 0; row < block.rows; row += Lanes::kRows) {
        for (std::size_t group = 0; group < block.groups; group += Lanes::kGroups) {
            compare_step<Lanes>(block, row, group);
        }
    }
}

template <class Lanes>
NearestKernel kernel_of() {
    return {Lanes::kLanes,         Lanes::kRows,          Lanes::kGroups,
            Lanes::kValuesPerWord, Lanes::kRowsAreSigned, compare_block<Lanes>};
}

}  // namespace
}  // namespace lumi
