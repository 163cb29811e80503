#include "meshing/depth/depth_memory.h"

#include <gtest/gtest.h>

#include "calib/work/error.h"

namespace lumi {
namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20;
constexpr std::uint64_t kPixels = 6'000'000;

DepthMemory predicted(std::size_t views, int threads, std::uint64_t budget_mib,
                      const std::string& model = "sweep", int max_neighbours = 4) {
    return predicted_depth_memory(std::vector<std::uint64_t>(views, kPixels), model, threads,
                                  budget_mib * kMiB, 150 * kMiB, max_neighbours);
}

TEST(DepthMemory, AViewMoreAddsItsPictureTwoMapsAndHalfOfItsContinuation) {
    // 3 bytes of colour, twice 4 of inverse depth and 1 of confidence, and half of the 4 that tell
    // how far each pixel is from what is known and of 1 that others tell of it.
    EXPECT_EQ(predicted(9, 1, 100'000).finishing - predicted(8, 1, 100'000).finishing,
              31 * kPixels / 2);
    EXPECT_EQ(predicted(9, 1, 100'000).in_use, 150 * kMiB);
}

TEST(DepthMemory, FewerViewsAtOneTimeKeepItWithinTheBudget) {
    for (const int threads : {1, 2, 8, 64}) {
        const DepthMemory memory = predicted(16, threads, 2048);
        EXPECT_LE(memory.peak(), 2048 * kMiB) << threads;
        EXPECT_LE(memory.views_matched, threads);
        EXPECT_GE(memory.views_matched, 1);
    }
    EXPECT_EQ(predicted(16, 8, 100'000).views_matched, 8);
    EXPECT_EQ(predicted(3, 8, 100'000).views_matched, 3);
    EXPECT_EQ(predicted(16, 8, 1).views_matched, 1);
    EXPECT_EQ(predicted(16, 8, 1).views_filled, 1);
}

TEST(DepthMemory, AsManyPredictorsAreMatchedAtOneTimeAsTheBudgetAllows) {
    EXPECT_EQ(predicted(40, 64, 100'000, "auto", 32).views_tried, 32);
    EXPECT_EQ(predicted(40, 8, 100'000, "auto", 32).views_tried, 8);
    EXPECT_EQ(predicted(40, 64, 100'000, "auto", 6).views_tried, 6);
    EXPECT_EQ(predicted(40, 64, 1, "auto", 32).views_tried, 1);
    for (const int neighbours : {4, 6, 8}) {
        const DepthMemory memory = predicted(16, 64, 2048, "auto", neighbours);
        EXPECT_LE(memory.in_use + memory.choosing, 2048 * kMiB) << neighbours;
        EXPECT_LT(memory.views_tried, neighbours);
    }
    EXPECT_GT(predicted(40, 64, 100'000, "auto", 32).choosing,
              2 * predicted(40, 64, 100'000, "auto", 4).choosing);
}

TEST(DepthMemory, AModelThatDoesMoreTakesMore) {
    std::uint64_t before = 0;
    for (const char* model : {"plane", "pair_stereo", "sweep", "patch_match"}) {
        const std::uint64_t matching = predicted(16, 2, 100'000, model).matching;
        EXPECT_GT(matching, before) << model;
        before = matching;
    }
}

TEST(DepthMemory, ALargerMapTakesMoreToMatchForEachOfItsPixels) {
    const auto matching = [](std::uint64_t pixels) {
        const auto memory =
            predicted_depth_memory({pixels}, "sweep", 1, 100'000 * kMiB, 150 * kMiB, 4);
        return memory.matching;
    };
    // As many costs a pixel as the sweep is sure to search, of three bytes, and the pictures.
    EXPECT_EQ(matching(24'000'000) - matching(12'000'000), 12'000'000U * (3 * 32 + 37 + 3 + 5));
}

TEST(DepthMemory, OfAutoIsThatOfWhatItChoseOnceThatIsKnown) {
    const std::vector<std::uint64_t> pixels(16, kPixels);
    const DepthMemory at_most = predicted(16, 2, 100'000, "auto");
    const auto of = [&](const std::string& chosen, bool predicted_photographs) {
        return predicted_memory_of_choice(at_most, pixels, chosen, predicted_photographs, 2,
                                          100'000 * kMiB)
            .peak();
    };
    EXPECT_EQ(of("plane", false), predicted(16, 2, 100'000, "plane").peak());
    EXPECT_EQ(of("patch_match", true), at_most.peak());
    EXPECT_GE(of("plane", true), at_most.in_use + at_most.choosing);
    EXPECT_LT(of("plane", true), of("patch_match", true));
}

TEST(DepthMemory, WhatTheMachineHasNotIsRefused) {
    const DepthMemory memory = predicted(16, 2, 2048);
    EXPECT_NO_THROW(require_memory(memory, memory.peak() - memory.in_use));
    try {
        require_memory(memory, memory.peak() - memory.in_use - 1);
        ADD_FAILURE() << "expected E-DEPTH-MEMORY";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), "E-DEPTH-MEMORY");
        EXPECT_EQ(error.kind(), ErrorKind::kResources);
    }
}

}  // namespace
}  // namespace lumi
