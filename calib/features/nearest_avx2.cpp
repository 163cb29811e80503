#include "calib/features/nearest_kernel.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>

// From here to the end of the file; everything it holds is this file's own.
#pragma GCC target("avx2")
#include "calib/features/nearest_kernel_loops.h"

namespace lumi {
namespace {

/// Eight columns at once; vpmaddwd multiplies pairs of 16-bit values and adds the two products.
struct Avx2Lanes {
    using Vector = __m256i;
    static constexpr std::size_t kLanes = 8;
    static constexpr std::size_t kRows = 4;
    static constexpr std::size_t kGroups = 2;
    static constexpr std::size_t kValuesPerWord = 2;
    static constexpr bool kRowsAreSigned = false;

    static Vector load(const std::uint32_t* from) {
        return _mm256_load_si256(reinterpret_cast<const __m256i*>(from));
    }
    static void store(std::uint32_t* to, Vector value) {
        _mm256_store_si256(reinterpret_cast<__m256i*>(to), value);
    }
    static Vector all(std::uint32_t value) { return _mm256_set1_epi32(static_cast<int>(value)); }
    static Vector multiply_add(Vector sum, Vector row, Vector column) {
        return _mm256_add_epi32(sum, _mm256_madd_epi16(row, column));
    }
    static Vector shifted(Vector value) { return _mm256_slli_epi32(value, kNearestIndexBits); }
    static Vector either(Vector a, Vector b) { return _mm256_or_si256(a, b); }
    static Vector larger(Vector a, Vector b) { return _mm256_max_epu32(a, b); }
    static Vector smaller(Vector a, Vector b) { return _mm256_min_epu32(a, b); }
};

}  // namespace

NearestKernel avx2_nearest_kernel() { return kernel_of<Avx2Lanes>(); }

}  // namespace lumi
#endif
