#include "calib/work/progress.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(QuietPart, StopsWhenTheWholeIsAskedTo) {
    SilentProgress whole;
    const QuietPart part(whole);
    EXPECT_FALSE(part.interrupted());
    EXPECT_NO_THROW(part.throw_if_interrupted());
    whole.interrupt();
    EXPECT_TRUE(part.interrupted());
    EXPECT_THROW(part.throw_if_interrupted(), Error);
}

}  // namespace
}  // namespace lumi
