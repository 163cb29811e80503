#include "calib/work/process_memory.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstddef>
#include <memory>
#include <vector>

namespace lumi {
namespace {

TEST(ProcessMemory, HoldsAsManyPiecesAsFitBesideWhatIsKept) {
    EXPECT_EQ(pieces_within(100, 40, 20, 8), 3);
    EXPECT_EQ(pieces_within(100, 40, 1, 8), 8);
    EXPECT_EQ(pieces_within(100, 100, 20, 8), 1);
    EXPECT_EQ(pieces_within(100, 200, 20, 8), 1) << "one there always is";
    EXPECT_EQ(pieces_within(100, 40, 0, 8), 8);
}

TEST(ProcessMemory, ThePeakRisesByWhatIsTakenAndCanBeForgotten) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer keeps what is freed for a while";
#endif
    constexpr std::size_t kTaken = std::size_t{64} << 20;
    if (!memory_in_use() || !forget_peak_memory()) GTEST_SKIP() << "no /proc here";
    const std::uint64_t before = *memory_in_use();
    { const std::vector<char> taken(kTaken, 1); }
    release_free_memory();
    EXPECT_GE(*peak_memory(), before + kTaken * 9 / 10);
    EXPECT_LT(*memory_in_use(), before + kTaken / 2);
    EXPECT_TRUE(forget_peak_memory());
    EXPECT_LT(*peak_memory(), before + kTaken / 2);
    EXPECT_GT(*memory_available(), 0U);
}

/// Pages that the system had to give for blocks that are freed together.
long pages_for_blocks() {
    rusage before{};
    getrusage(RUSAGE_SELF, &before);
    constexpr std::size_t kBlocks = 600;
    constexpr std::size_t kBlockBytes = std::size_t{64} << 10;
    std::vector<std::unique_ptr<char[]>> blocks;
    for (std::size_t i = 0; i < kBlocks; ++i) {
        blocks.push_back(std::make_unique<char[]>(kBlockBytes));
        blocks.back()[kBlockBytes / 2] = 1;
    }
    blocks.clear();
    rusage after{};
    getrusage(RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt;
}

TEST(ProcessMemory, WhatIsKeptIsNotTakenFromTheSystemAgain) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the address sanitizer has a heap of its own";
#endif
    keep_little_free_memory();
    static_cast<void>(pages_for_blocks());
    EXPECT_GT(pages_for_blocks(), 1000);
    keep_free_memory();
    static_cast<void>(pages_for_blocks());
    EXPECT_LT(pages_for_blocks(), 100);
    keep_little_free_memory();
}

}  // namespace
}  // namespace lumi
