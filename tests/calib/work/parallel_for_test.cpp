#include "calib/work/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

namespace lumi {
namespace {

TEST(ParallelFor, CallsEachIndexOnceForAnyNumberOfThreads) {
    for (const int threads : {0, 1, 2, 3, 16}) {
        for (const int count : {0, 1, 2, 1000}) {
            std::vector<std::atomic<int>> calls(static_cast<std::size_t>(count));
            parallel_for(count, threads, [&](int i) { ++calls[static_cast<std::size_t>(i)]; });
            for (const auto& call : calls) ASSERT_EQ(call, 1) << threads << " threads";
        }
    }
}

TEST(ParallelFor, RethrowsAndEndsTheRemainingWork) {
    for (const int threads : {1, 4}) {
        std::atomic<int> calls{0};
        const auto work = [&] {
            parallel_for(1000000, threads, [&](int i) {
                ++calls;
                if (i == 10) throw std::runtime_error("ten");
            });
        };
        EXPECT_THROW(work(), std::runtime_error);
        EXPECT_LT(calls, 1000000);
    }
}

TEST(ParallelFor, ZeroThreadsStandForAllCores) {
    EXPECT_GE(resolve_threads(0), 1);
    EXPECT_EQ(resolve_threads(3), 3);
}

}  // namespace
}  // namespace lumi
