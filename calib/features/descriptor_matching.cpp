#include "calib/features/descriptor_matching.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace lumi {
namespace {

/// The two most similar descriptors of the other photograph, by dot product.
struct Nearest {
    std::int32_t best = -1;
    std::int32_t second = -1;
    std::uint32_t index = 0;

    void offer(std::int32_t similarity, std::uint32_t candidate) {
        if (similarity > best) {
            second = best;
            best = similarity;
            index = candidate;
        } else if (similarity > second) {
            second = similarity;
        }
    }
};

constexpr std::size_t kRows = 32;      // 8 KiB of descriptors and
constexpr std::size_t kColumns = 128;  // 32 KiB: a tile stays in the nearest caches.

struct Tile {
    std::span<const Descriptor> rows;
    std::span<const Descriptor> columns;
    std::array<std::int32_t, kRows * kColumns> similarity;
};

/// Inlined into one function per instruction set; the compiler makes a loop of multiply-add
/// instructions of it.
[[gnu::always_inline]] inline void fill_tile(Tile& tile) {
    for (std::size_t row = 0; row < tile.rows.size(); ++row) {
        for (std::size_t column = 0; column < tile.columns.size(); ++column) {
            const std::int16_t* const a = tile.rows[row].data();
            const std::int16_t* const b = tile.columns[column].data();
            std::int32_t sum = 0;
            for (std::size_t bin = 0; bin < kDescriptorSize; ++bin) {
                sum += static_cast<std::int32_t>(a[bin]) * static_cast<std::int32_t>(b[bin]);
            }
            tile.similarity[row * kColumns + column] = sum;
        }
    }
}

using FillTile = void (*)(Tile&);

void fill_tile_portable(Tile& tile) { fill_tile(tile); }

#if defined(__x86_64__) && defined(__GNUC__)
[[gnu::target("avx2")]] void fill_tile_avx2(Tile& tile) { fill_tile(tile); }

FillTile fastest_fill_tile() {
    return __builtin_cpu_supports("avx2") ? fill_tile_avx2 : fill_tile_portable;
}
#else
FillTile fastest_fill_tile() { return fill_tile_portable; }
#endif

double angle_rad(std::int32_t similarity) {
    constexpr double kOne = 512.0 * 512.0;
    return std::acos(std::clamp(similarity / kOne, 0.0, 1.0));
}

bool is_distinct(const Nearest& nearest, const DescriptorMatchingOptions& options) {
    const double best = angle_rad(nearest.best);
    return best <= options.max_angle_rad && best < options.max_ratio * angle_rad(nearest.second);
}

}  // namespace

std::vector<FeatureMatch> match_descriptors(std::span<const Descriptor> first,
                                            std::span<const Descriptor> second,
                                            const DescriptorMatchingOptions& options) {
    const FillTile fill = fastest_fill_tile();
    std::vector<Nearest> of_first(first.size());
    std::vector<Nearest> of_second(second.size());
    Tile tile{};
    for (std::size_t row = 0; row < first.size(); row += kRows) {
        tile.rows = first.subspan(row, std::min(kRows, first.size() - row));
        for (std::size_t column = 0; column < second.size(); column += kColumns) {
            tile.columns = second.subspan(column, std::min(kColumns, second.size() - column));
            fill(tile);
            for (std::size_t i = 0; i < tile.rows.size(); ++i) {
                for (std::size_t j = 0; j < tile.columns.size(); ++j) {
                    const std::int32_t similarity = tile.similarity[i * kColumns + j];
                    of_first[row + i].offer(similarity, static_cast<std::uint32_t>(column + j));
                    of_second[column + j].offer(similarity, static_cast<std::uint32_t>(row + i));
                }
            }
        }
    }
    std::vector<FeatureMatch> matches;
    for (std::size_t index = 0; index < first.size(); ++index) {
        const Nearest& there = of_first[index];
        if (there.best < 0) continue;
        const Nearest& back = of_second[there.index];
        if (back.index == index && is_distinct(there, options) && is_distinct(back, options)) {
            matches.push_back({static_cast<std::uint32_t>(index), there.index});
        }
    }
    return matches;
}

}  // namespace lumi
