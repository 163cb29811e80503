#include "calib/work/counted.h"

#include <gtest/gtest.h>

namespace lumi {
namespace {

TEST(Counted, OneIsSingularAndNothingElseIs) {
    EXPECT_EQ(counted(1, "view"), "1 view");
    EXPECT_EQ(counted(std::size_t{1}, "OpenGL error"), "1 OpenGL error");
    EXPECT_EQ(counted(0, "view"), "0 views");
    EXPECT_EQ(counted(21, "view"), "21 views");
}

}  // namespace
}  // namespace lumi
