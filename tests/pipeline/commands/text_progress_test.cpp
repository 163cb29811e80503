#include "pipeline/commands/text_progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

namespace lumi {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(TextProgress, ANameInANoteSteersNoTerminal) {
    std::ostringstream lines;
    LineProgress(lines).note("left out a\x1b[2Jb \xe9.jpg");
    EXPECT_EQ(lines.str(), "left out a\\x1b[2Jb \\xe9.jpg\n");

    std::ostringstream terminal;
    BarProgress bar(terminal);
    bar.note("left out a\x1b[2Jb \xe9.jpg");
    EXPECT_THAT(terminal.str(), EndsWith("left out a\\x1b[2Jb \\xe9.jpg\n"));
    EXPECT_THAT(terminal.str(), Not(HasSubstr("\x1b[2J")));
}

}  // namespace
}  // namespace lumi
