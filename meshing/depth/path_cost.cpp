#include "meshing/depth/path_cost.h"

#include <cstring>

#include "meshing/depth/instruction_sets.h"

namespace lumi {
namespace {

using Bytes8 [[gnu::vector_size(8)]] = std::uint8_t;
using Bytes16 [[gnu::vector_size(16)]] = std::uint8_t;
using Words8 [[gnu::vector_size(16)]] = std::uint16_t;
using Words16 [[gnu::vector_size(32)]] = std::uint16_t;

template <class Vector>
[[gnu::always_inline]] inline void load(const void* from, Vector& to) {
    std::memcpy(&to, from, sizeof(to));
}

template <class Vector>
[[gnu::always_inline]] inline Vector smaller(Vector a, Vector b) {
    return a < b ? a : b;
}

[[gnu::always_inline]] inline std::uint8_t least(Bytes8 v) {
    v = smaller(v, __builtin_shufflevector(v, v, 4, 5, 6, 7, 0, 1, 2, 3));
    v = smaller(v, __builtin_shufflevector(v, v, 2, 3, 0, 1, 6, 7, 4, 5));
    v = smaller(v, __builtin_shufflevector(v, v, 1, 0, 3, 2, 5, 4, 7, 6));
    return v[0];
}

struct PathStep {
    std::uint8_t previous_min;
    std::uint8_t p1;
    std::uint8_t p2;
};

/// Sixteen planes at a time, and eight where so many are left.
struct AdvancePath {
    template <class Bytes, class Words>
    LUMI_KERNEL Bytes block(const std::uint8_t* cost, const std::uint8_t* previous,
                            const PathStep& step, std::uint8_t* current, std::uint16_t* sum) {
        Bytes below, stay, above, own;
        load(previous - 1, below);
        load(previous, stay);
        load(previous + 1, above);
        load(cost, own);
        const auto jump = Bytes{} + static_cast<std::uint8_t>(step.previous_min + step.p2);
        const Bytes best = smaller<Bytes>(smaller<Bytes>(below + step.p1, above + step.p1),
                                          smaller<Bytes>(stay, jump));
        const Bytes total = own + best - step.previous_min;
        std::memcpy(current, &total, sizeof(total));
        Words sums;
        load(sum, sums);
        sums += __builtin_convertvector(total, Words);
        std::memcpy(sum, &sums, sizeof(sums));
        return total;
    }

    LUMI_KERNEL void run(const std::uint8_t* cost, const std::uint8_t* previous,
                         const PathStep* step, int count, std::uint8_t* current, std::uint16_t* sum,
                         std::uint8_t* minimum) {
        Bytes16 lowest = Bytes16{} + kUnreachable;
        int k = 0;
        for (; k + 16 <= count; k += 16) {
            lowest = smaller(lowest, block<Bytes16, Words16>(cost + k, previous + k, *step,
                                                             current + k, sum + k));
        }
        Bytes8 lower = __builtin_shufflevector(lowest, lowest, 0, 1, 2, 3, 4, 5, 6, 7);
        lower =
            smaller(lower, __builtin_shufflevector(lowest, lowest, 8, 9, 10, 11, 12, 13, 14, 15));
        if (k < count) {
            lower = smaller(
                lower, block<Bytes8, Words8>(cost + k, previous + k, *step, current + k, sum + k));
        }
        *minimum = least(lower);
    }
};

}  // namespace

std::uint8_t advance_path(const std::uint8_t* cost, const std::uint8_t* previous,
                          std::uint8_t previous_min, std::uint8_t p1, std::uint8_t p2, int count,
                          std::uint8_t* current, std::uint16_t* sum) {
    const PathStep step{previous_min, p1, p2};
    std::uint8_t minimum = 0;
    run_fastest<AdvancePath>(cost, previous, &step, count, current, sum, &minimum);
    return minimum;
}

}  // namespace lumi
