#pragma once

#include <cstddef>
#include <cstdint>

#include "calib/features/features.h"

namespace lumi {

/// Dot products are kept in the upper 19 bits of a word, and below them the complement of an index:
/// the larger word is the more similar descriptor and, of equals, the one that comes first. Keeping
/// the two best then takes a maximum, a minimum and another maximum, without a branch.
constexpr unsigned kNearestIndexBits = 13;
constexpr std::uint32_t kNearestIndexMask = (1U << kNearestIndexBits) - 1;

/// Rows (descriptors of one photograph) against columns (of the other). A word holds 4 values of 8
/// bits or 2 of 16 bits. All arrays are aligned to 64 bytes; what fills rows and columns up to the
/// kernel's steps is zero, and so never found.
struct NearestBlock {
    const std::uint32_t* row_words = nullptr;      ///< [row][word]
    std::size_t rows = 0;                          ///< At most 2^13.
    const std::uint32_t* column_words = nullptr;   ///< [group][word][lane]
    const std::uint32_t* column_starts = nullptr;  ///< [group][lane]: where the sums begin.
    std::size_t groups = 0;                        ///< At most 2^13.
    // The two best so far: in rows the index is the group's, in columns it is the row's.
    std::uint32_t* row_best = nullptr;  ///< [row][lane]
    std::uint32_t* row_second = nullptr;
    std::uint32_t* column_best = nullptr;  ///< [group][lane]
    std::uint32_t* column_second = nullptr;
};

/// One instruction set's way to compare.
struct NearestKernel {
    std::size_t lanes = 0;  ///< Columns of a group.
    std::size_t rows_a_step = 0;
    std::size_t groups_a_step = 0;
    std::size_t values_a_word = 0;
    /// Rows are stored as signed bytes, 128 less than they are; the columns' starts make up for it.
    bool rows_are_signed = false;
    void (*compare)(const NearestBlock&) = nullptr;
};

[[nodiscard]] NearestKernel portable_nearest_kernel();
#if defined(__x86_64__) && defined(__GNUC__)
[[nodiscard]] NearestKernel avx2_nearest_kernel();
[[nodiscard]] NearestKernel avx512_vnni_nearest_kernel();
#endif

}  // namespace lumi
