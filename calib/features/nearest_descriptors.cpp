#include "calib/features/nearest_descriptors.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>

#include "calib/features/nearest_kernel.h"

namespace lumi {
namespace {

/// A multiple of every kernel's rows a step, so that no index in a block needs more than its bits.
constexpr std::size_t kBlockRows = 8160;
static_assert(kBlockRows <= kNearestIndexMask);
constexpr std::size_t kBlockColumns = 2048;  ///< 256 to 512 KiB: stays in the second cache.
constexpr std::uint32_t kLengthLimit = 1U << (32U - kNearestIndexBits);

struct alignas(64) CacheLine {
    std::array<std::uint32_t, 16> words{};
};

/// Words in memory that begins where a cache line does.
class AlignedWords {
 public:
    explicit AlignedWords(std::size_t count) : lines_((count + 15) / 16) {}
    [[nodiscard]] std::uint32_t* data() {
        return lines_.empty() ? nullptr : lines_.front().words.data();
    }
    void clear() { std::fill(lines_.begin(), lines_.end(), CacheLine{}); }

 private:
    std::vector<CacheLine> lines_;
};

std::size_t rounded_up(std::size_t count, std::size_t step) {
    return (count + step - 1) / step * step;
}

std::uint32_t word_of(const Descriptor& descriptor, std::size_t word, std::size_t values_a_word,
                      std::uint32_t flipped_bits) {
    const std::size_t bits = 32 / values_a_word;
    std::uint32_t result = 0;
    for (std::size_t value = 0; value < values_a_word; ++value) {
        result |= static_cast<std::uint32_t>(descriptor[word * values_a_word + value])
                  << (value * bits);
    }
    return result ^ flipped_bits;
}

void write_rows(const NearestKernel& kernel, std::span<const Descriptor> rows, AlignedWords& to) {
    // A byte less 128 is the byte with its highest bit flipped.
    const std::uint32_t flipped_bits = kernel.rows_are_signed ? 0x80808080U : 0U;
    const std::size_t words = kDescriptorSize / kernel.values_a_word;
    const Descriptor nothing{};
    for (std::size_t row = 0; row < rounded_up(rows.size(), kernel.rows_a_step); ++row) {
        const Descriptor& descriptor = row < rows.size() ? rows[row] : nothing;
        for (std::size_t word = 0; word < words; ++word) {
            to.data()[row * words + word] =
                word_of(descriptor, word, kernel.values_a_word, flipped_bits);
        }
    }
}

void write_columns(const NearestKernel& kernel, std::span<const Descriptor> columns,
                   AlignedWords& words_to, AlignedWords& starts_to) {
    const std::size_t words = kDescriptorSize / kernel.values_a_word;
    words_to.clear();
    starts_to.clear();
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const std::size_t group = column / kernel.lanes;
        const std::size_t lane = column % kernel.lanes;
        std::uint32_t sum = 0;
        for (const std::uint8_t value : columns[column]) sum += value;
        starts_to.data()[column] = kernel.rows_are_signed ? 128 * sum : 0;
        for (std::size_t word = 0; word < words; ++word) {
            words_to.data()[(group * words + word) * kernel.lanes + lane] =
                word_of(columns[column], word, kernel.values_a_word, 0);
        }
    }
}

/// Joins the two best of some descriptors with the two best of others.
void join(NearestDescriptors& nearest, const NearestDescriptors& others) {
    if (others.best == 0) return;
    const std::uint32_t loser = std::min(nearest.best, others.best);
    nearest.second = std::max({loser, nearest.second, others.second});
    if (others.best > nearest.best ||
        (others.best == nearest.best && others.index < nearest.index)) {
        nearest.best = others.best;
        nearest.index = others.index;
    }
}

std::uint32_t similarity_in(std::uint32_t word) { return word >> kNearestIndexBits; }
std::size_t index_in(std::uint32_t word) { return kNearestIndexMask - (word & kNearestIndexMask); }

/// What the kernel works on: all rows of a block against a block of columns.
class Comparison {
 public:
    Comparison(const NearestKernel& kernel, std::size_t rows, std::size_t columns)
        : kernel_(kernel),
          words_(kDescriptorSize / kernel.values_a_word),
          row_words_(padded_rows(rows) * words_),
          column_words_(padded_columns(columns) * words_),
          column_starts_(padded_columns(columns)),
          row_best_(padded_rows(rows) * kernel.lanes),
          row_second_(padded_rows(rows) * kernel.lanes),
          column_best_(padded_columns(columns)),
          column_second_(padded_columns(columns)) {}

    void compare(std::span<const Descriptor> rows, std::size_t first_row,
                 std::span<const Descriptor> columns, std::size_t first_column,
                 NearestBothWays& result) {
        if (first_column == 0) write_rows(kernel_, rows, row_words_);
        write_columns(kernel_, columns, column_words_, column_starts_);
        for (AlignedWords* words : {&row_best_, &row_second_, &column_best_, &column_second_}) {
            words->clear();
        }
        kernel_.compare({row_words_.data(), padded_rows(rows.size()), column_words_.data(),
                         column_starts_.data(), padded_columns(columns.size()) / kernel_.lanes,
                         row_best_.data(), row_second_.data(), column_best_.data(),
                         column_second_.data()});
        for (std::size_t row = 0; row < rows.size(); ++row) {
            join_row(row, first_column, result.of_first[first_row + row]);
        }
        for (std::size_t column = 0; column < columns.size(); ++column) {
            const std::uint32_t best = column_best_.data()[column];
            join(result.of_second[first_column + column],
                 {similarity_in(best), similarity_in(column_second_.data()[column]),
                  static_cast<std::uint32_t>(first_row + index_in(best))});
        }
    }

 private:
    [[nodiscard]] std::size_t padded_rows(std::size_t rows) const {
        return rounded_up(rows, kernel_.rows_a_step);
    }
    [[nodiscard]] std::size_t padded_columns(std::size_t columns) const {
        return rounded_up(columns, kernel_.lanes * kernel_.groups_a_step);
    }
    void join_row(std::size_t row, std::size_t first_column, NearestDescriptors& nearest) {
        const std::uint32_t* const best = row_best_.data() + row * kernel_.lanes;
        const std::uint32_t* const second = row_second_.data() + row * kernel_.lanes;
        for (std::size_t lane = 0; lane < kernel_.lanes; ++lane) {
            const std::size_t column = index_in(best[lane]) * kernel_.lanes + lane;
            join(nearest, {similarity_in(best[lane]), similarity_in(second[lane]),
                           static_cast<std::uint32_t>(first_column + column)});
        }
    }

    NearestKernel kernel_;
    std::size_t words_;
    AlignedWords row_words_;
    AlignedWords column_words_;
    AlignedWords column_starts_;
    AlignedWords row_best_;
    AlignedWords row_second_;
    AlignedWords column_best_;
    AlignedWords column_second_;
};

void expect_short(std::span<const Descriptor> descriptors) {
    for (const Descriptor& descriptor : descriptors) {
        std::uint32_t sum = 0;
        for (const std::uint8_t value : descriptor) sum += std::uint32_t{value} * value;
        if (sum >= kLengthLimit) throw std::invalid_argument("a descriptor longer than RootSIFT's");
    }
}

NearestKernel kernel_for(DescriptorInstructions instructions) {
    const auto here = descriptor_instructions_here();
    if (std::find(here.begin(), here.end(), instructions) == here.end()) {
        throw std::invalid_argument("this machine does not have the instructions " +
                                    std::string(name_of(instructions)));
    }
    switch (instructions) {
#if defined(__x86_64__) && defined(__GNUC__)
        case DescriptorInstructions::kAvx2:
            return avx2_nearest_kernel();
        case DescriptorInstructions::kAvx512Vnni:
            return avx512_vnni_nearest_kernel();
#endif
        default:
            return portable_nearest_kernel();
    }
}

}  // namespace

std::string_view name_of(DescriptorInstructions instructions) {
    switch (instructions) {
        case DescriptorInstructions::kPortable:
            return "portable";
        case DescriptorInstructions::kAvx2:
            return "AVX2";
        case DescriptorInstructions::kAvx512Vnni:
            return "AVX-512 VNNI";
    }
    assert(false);
    return "";
}

std::vector<DescriptorInstructions> descriptor_instructions_here() {
    std::vector<DescriptorInstructions> here{DescriptorInstructions::kPortable};
#if defined(__x86_64__) && defined(__GNUC__)
    if (__builtin_cpu_supports("avx2")) here.push_back(DescriptorInstructions::kAvx2);
    if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vnni")) {
        here.push_back(DescriptorInstructions::kAvx512Vnni);
    }
#endif
    return here;
}

NearestBothWays nearest_descriptors(std::span<const Descriptor> first,
                                    std::span<const Descriptor> second,
                                    DescriptorInstructions instructions) {
    expect_short(first);
    expect_short(second);
    NearestBothWays result;
    result.of_first.resize(first.size());
    result.of_second.resize(second.size());
    Comparison comparison(kernel_for(instructions), std::min(first.size(), kBlockRows),
                          std::min(second.size(), kBlockColumns));
    for (std::size_t row = 0; row < first.size(); row += kBlockRows) {
        const auto rows = first.subspan(row, std::min(kBlockRows, first.size() - row));
        for (std::size_t column = 0; column < second.size(); column += kBlockColumns) {
            comparison.compare(
                rows, row, second.subspan(column, std::min(kBlockColumns, second.size() - column)),
                column, result);
        }
    }
    return result;
}

}  // namespace lumi
