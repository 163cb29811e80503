#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(UnknownWord, AMisspeltCommandIsAnsweredWithTheNearest) {
    const Outcome outcome = lumi("biuld photos/");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.talk,
              "error E-USAGE: unknown command `biuld`\n"
              "  -> did you mean `build`? see `lumi --help`\n");
    EXPECT_THAT(lumi("--quiet doctr photos/").talk, HasSubstr("did you mean `doctor`?"));
}

TEST(UnknownWord, AMisspeltOptionIsAnsweredWithTheNearestOfItsCommand) {
    const auto talk_of = [](const std::string& line) {
        const Outcome outcome = lumi(line);
        EXPECT_EQ(outcome.exit_code, 2) << line;
        return outcome.talk;
    };
    EXPECT_EQ(talk_of("view p.lumi --sise 640x480"),
              "error E-USAGE: unknown option `--sise`\n"
              "  -> did you mean `--size`? see `lumi view --help`\n");
    EXPECT_THAT(talk_of("bench-rivals --frmaes=3"), HasSubstr("did you mean `--frames`?"));
    // Of a group of which exactly one must be there, and of the program itself.
    EXPECT_THAT(talk_of("render p.lumi --veiw a.jpg --out a.png"),
                HasSubstr("did you mean `--view`?"));
    EXPECT_THAT(talk_of("--jsno build photos/"), HasSubstr("did you mean `--json`?"));
}

TEST(UnknownWord, NothingIsSuggestedWhereNothingIsNear) {
    const std::string talk = lumi("reconstruct photos/").talk;
    EXPECT_THAT(talk, HasSubstr("unknown command `reconstruct`\n  -> see `lumi --help`"));
    EXPECT_THAT(talk, Not(HasSubstr("did you mean")));
}

TEST(UnknownWord, OfOtherWrongLinesTheReasonIsSaid) {
    EXPECT_THAT(lumi("build").talk, HasSubstr("CONFIG is required"));
    EXPECT_THAT(lumi("build --threads -3 photos/").talk, HasSubstr("--threads"));
}

TEST(UnknownWord, MachinesAreToldTheSame) {
    const auto error =
        nlohmann::json::parse(lumi("--json render p.lumi --heigth 3").out).at("error");
    EXPECT_EQ(error.at("what"), "unknown option `--heigth`");
}

}  // namespace
}  // namespace lumi
