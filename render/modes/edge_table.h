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
    EdgeTable() : slots_(std::size_t{1} << kFirstBits) {}

    /// The number of the edge between two vertices; a new one where it has none.
    [[nodiscard]] std::uint32_t number_of(std::uint32_t a, std::uint32_t b) {
        if (2 * static_cast<std::size_t>(count_) >= slots_.size()) grow();
        const std::uint64_t key =
            a < b ? (std::uint64_t{a} << 32) | b : (std::uint64_t{b} << 32) | a;
        Slot& slot = slots_[place_of(key)];
        if (slot.number == kFree) slot = {key, count_++};
        return slot.number;
    }
    [[nodiscard]] std::uint32_t count() const { return count_; }

    void clear() {
        slots_.assign(slots_.size(), Slot{});
        count_ = 0;
    }

 private:
    static constexpr int kFirstBits = 12;
    static constexpr std::uint32_t kFree = 0xffffffffU;
    struct Slot {
        std::uint64_t key = 0;
        std::uint32_t number = kFree;
    };

    /// Where the key is, or would be put: from its hash (Fibonacci hashing) on, the first that
    /// holds it or is free.
    [[nodiscard]] std::size_t place_of(std::uint64_t key) const {
        const int bits = std::countr_zero(slots_.size());
        std::size_t place = (key * 0x9e3779b97f4a7c15ULL) >> (64 - bits);
        while (slots_[place].number != kFree && slots_[place].key != key)
            place = (place + 1) & (slots_.size() - 1);
        return place;
    }

    void grow() {
        std::vector<Slot> known(2 * slots_.size());
        known.swap(slots_);
        for (const Slot& slot : known)
            if (slot.number != kFree) slots_[place_of(slot.key)] = slot;
    }

    std::vector<Slot> slots_;
    std::uint32_t count_ = 0;
};

}  // namespace lumi
