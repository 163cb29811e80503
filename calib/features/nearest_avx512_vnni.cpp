#include "calib/features/nearest_kernel.h"

#if defined(__x86_64__) && defined(__GNUC__)
#include <immintrin.h>

// GCC 12 takes the deliberately undefined operands in its own header for mistakes (GCC bug 105593).
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"

// From here to the end of the file; everything it holds is this file's own.
#pragma GCC target("avx512f,avx512vnni")
#include "calib/features/nearest_kernel_loops.h"

namespace lumi {
namespace {

/// Sixteen columns at once; vpdpbusd multiplies four unsigned with four signed bytes and adds the
/// products: 64 multiplications an instruction. The rows are the signed ones, a - 128, and each
/// column's sum begins with 128 times the sum of its values, so that the result is exact.
struct Avx512VnniLanes {
    using Vector = __m512i;
    static constexpr std::size_t kLanes = 16;
    static constexpr std::size_t kRows = 12;
    static constexpr std::size_t kGroups = 2;
    static constexpr std::size_t kValuesPerWord = 4;
    static constexpr bool kRowsAreSigned = true;

    static Vector load(const std::uint32_t* from) { return _mm512_load_si512(from); }
    static void store(std::uint32_t* to, Vector value) { _mm512_store_si512(to, value); }
    static Vector all(std::uint32_t value) { return _mm512_set1_epi32(static_cast<int>(value)); }
    static Vector multiply_add(Vector sum, Vector row, Vector column) {
        return _mm512_dpbusd_epi32(sum, column, row);
    }
    static Vector shifted(Vector value) { return _mm512_slli_epi32(value, kNearestIndexBits); }
    static Vector either(Vector a, Vector b) { return _mm512_or_si512(a, b); }
    static Vector larger(Vector a, Vector b) { return _mm512_max_epu32(a, b); }
    static Vector smaller(Vector a, Vector b) { return _mm512_min_epu32(a, b); }
};

}  // namespace

NearestKernel avx512_vnni_nearest_kernel() { return kernel_of<Avx512VnniLanes>(); }

}  // namespace lumi
#endif
