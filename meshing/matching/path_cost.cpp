#include "meshing/matching/path_cost.h"

#include <cstring>

#include "meshing/warp/instruction_sets.h"

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

/// Sixteen planes at a time, and eight where so many are left.
struct AdvancePaths {
    /// Extends one path by as many planes as a vector holds.
    template <class Bytes>
    LUMI_KERNEL Bytes extended(const Bytes& own, const IncomingPath& path, std::uint8_t p1, int k) {
        Bytes below, stay, above;
        load(path.previous + k - 1, below);
        load(path.previous + k, stay);
        load(path.previous + k + 1, above);
        const auto jump = Bytes{} + static_cast<std::uint8_t>(path.previous_min + path.p2);
        const Bytes best =
            smaller<Bytes>(smaller<Bytes>(below + p1, above + p1), smaller<Bytes>(stay, jump));
        const Bytes total = own + best - path.previous_min;
        std::memcpy(path.current + k, &total, sizeof(total));
        return total;
    }

    /// All paths, and their sum.
    template <class Bytes, class Words>
    LUMI_KERNEL void block(const std::uint8_t* cost, const IncomingPath* paths, std::uint8_t p1,
                           int k, bool adds, std::uint16_t* sum, Bytes* lowest) {
        Bytes own;
        load(cost + k, own);
        Words sums{};
        if (adds) load(sum + k, sums);
        for (int i = 0; i < kPathsAtOnce; ++i) {
            const Bytes total = extended(own, paths[i], p1, k);
            lowest[i] = smaller(lowest[i], total);
            sums += __builtin_convertvector(total, Words);
        }
        std::memcpy(sum + k, &sums, sizeof(sums));
    }

    LUMI_KERNEL void run(const std::uint8_t* cost, const IncomingPath* paths, std::uint8_t p1,
                         int count, bool adds, std::uint16_t* sum, std::uint8_t* minima) {
        Bytes16 lowest[kPathsAtOnce];
        Bytes8 lower[kPathsAtOnce];
        for (Bytes16& values : lowest) values = Bytes16{} + kUnreachable;
        int k = 0;
        for (; k + 16 <= count; k += 16) {
            block<Bytes16, Words16>(cost, paths, p1, k, adds, sum, lowest);
        }
        for (int i = 0; i < kPathsAtOnce; ++i) {
            lower[i] = smaller(
                __builtin_shufflevector(lowest[i], lowest[i], 0, 1, 2, 3, 4, 5, 6, 7),
                __builtin_shufflevector(lowest[i], lowest[i], 8, 9, 10, 11, 12, 13, 14, 15));
        }
        if (k < count) block<Bytes8, Words8>(cost, paths, p1, k, adds, sum, lower);
        for (int i = 0; i < kPathsAtOnce; ++i) minima[i] = least(lower[i]);
    }
};

}  // namespace

void advance_paths(const std::uint8_t* cost, const IncomingPath paths[kPathsAtOnce],
                   std::uint8_t p1, int count, bool adds, std::uint16_t* sum,
                   std::uint8_t minima[kPathsAtOnce]) {
    run_fastest<AdvancePaths>(cost, paths, p1, count, adds, sum, minima);
}

}  // namespace lumi
