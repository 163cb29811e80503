#include "calib/work/process_memory.h"

#include <gtest/gtest.h>

#include <vector>

namespace lumi {
namespace {

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

}  // namespace
}  // namespace lumi
