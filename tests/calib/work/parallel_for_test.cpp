#include "calib/work/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>
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

TEST(ParallelFor, BodiesMayCallItAgain) {
    for (const int threads : {1, 2, 16}) {
        std::atomic<int> calls{0};
        parallel_for(20, threads, [&](int) {
            parallel_for(10, threads,
                         [&](int) { parallel_for(5, threads, [&](int) { ++calls; }); });
        });
        EXPECT_EQ(calls, 1000) << threads << " threads";
    }
}

TEST(ParallelFor, ServesSeveralCallersAtOnce) {
    std::atomic<int> calls{0};
    {
        std::vector<std::jthread> callers;
        for (int caller = 0; caller < 4; ++caller) {
            callers.emplace_back([&] {
                for (int i = 0; i < 200; ++i) parallel_for(7, 3, [&](int) { ++calls; });
            });
        }
    }
    EXPECT_EQ(calls, 4 * 200 * 7);
}

TEST(ParallelFor, AFailureWithinReachesTheOutermostCaller) {
    EXPECT_THROW(parallel_for(8, 4,
                              [](int) {
                                  parallel_for(8, 4, [](int i) {
                                      if (i == 3) throw std::runtime_error("three");
                                  });
                              }),
                 std::runtime_error);
}

TEST(ParallelFor, RunsCoverEachIndexOnce) {
    for (const std::size_t count : {0U, 1U, 99U, 100U, 101U}) {
        std::vector<std::atomic<int>> calls(count);
        parallel_for_runs(count, 10, 3, [&](std::size_t first, std::size_t end) {
            EXPECT_LE(end - first, 10U);
            for (std::size_t i = first; i < end; ++i) ++calls[i];
        });
        for (const auto& call : calls) ASSERT_EQ(call, 1) << count;
    }
}

TEST(ParallelFor, ZeroThreadsStandForAllCores) {
    EXPECT_GE(resolve_threads(0), 1);
    EXPECT_EQ(resolve_threads(3), 3);
}

}  // namespace
}  // namespace lumi
