#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace lumi {

/// Numbers the edges between vertices: 0, 1, 2 ... in the order in which they are first asked for,
/// the same from both ends. Forgetting all of them keeps the memory.
class EdgeTable {
 public:
    EdgeTable() : numbers_(std::size_t{1} << kFirstBits, kFree) {}

    /// The number of the edge between two vertices; a new one where it has none.
    [[nodiscard]] std::uint32_t number_of(std::uint32_t a, std::uint32_t b) {
        if (2 * keys_.size() >= numbers_.size()) grow();
        const std::uint64_t key =
            a < b ? (std::uint64_t{a} << 32) | b : (std::uint64_t{b} << 32) | a;
        std::uint32_t& number = numbers_[place_of(key)];
        if (number == kFree) {
            number = count();
            keys_.push_back(key);
        }
        return number;
    }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(keys_.size()); }

    void clear() {
        numbers_.assign(numbers_.size(), kFree);
        keys_.clear();
    }

 private:
    static constexpr int kFirstBits = 12;
    static constexpr std::uint32_t kFree = 0xffffffffU;

    /// Where the key's number is, or would be put: from its hash (Fibonacci hashing) on, the first
    /// that is the key's or free.
    [[nodiscard]] std::size_t place_of(std::uint64_t key) const {
        const int bits = std::countr_zero(numbers_.size());
        std::size_t place = (key * 0x9e3779b97f4a7c15ULL) >> (64 - bits);
        while (numbers_[place] != kFree && keys_[numbers_[place]] != key)
            place = (place + 1) & (numbers_.size() - 1);
        return place;
    }

    void grow() {
        numbers_.assign(2 * numbers_.size(), kFree);
        for (std::uint32_t number = 0; number < keys_.size(); ++number)
            numbers_[place_of(keys_[number])] = number;
    }

    std::vector<std::uint32_t> numbers_;  ///< Small, as it is read all over.
    std::vector<std::uint64_t> keys_;     ///< By number.
};

}  // namespace lumi
