#include "calib/work/formatted.h"

#include <gtest/gtest.h>

#include "calib/work/svg_escaped.h"

namespace lumi {
namespace {

TEST(Formatted, IsWhatPrintfPrintsOfAnyLength) {
    EXPECT_EQ(formatted("%d of %s, %.2f", 3, "seven", 0.125), "3 of seven, 0.12");
    EXPECT_EQ(formatted("%5000d", 1).size(), 5000u);
    EXPECT_EQ(formatted("%s", ""), "");
}

TEST(SvgEscaped, LeavesNothingThatXmlWouldTakeForMarkupOrForbids) {
    EXPECT_EQ(svg_escaped("a<b>&c\x01\x1b[0m\n"), "a&lt;b&gt;&amp;c[0m");
}

}  // namespace
}  // namespace lumi
