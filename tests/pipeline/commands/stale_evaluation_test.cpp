#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "calib/work/whole_file.h"
#include "tests/pipeline/box_line.h"
#include "tests/pipeline/built_program.h"

namespace lumi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class StaleEvaluation : public BoxLine {};

TEST_F(StaleEvaluation, ScoresAreOfThePackageThatWasRecorded) {
    configure("[evaluate]\nhold_out = [\"IMG_0005.png\"]\n");
    ASSERT_EQ(build(), "rrrrr");
    const fs::path record = workspace() / "pack" / "pack.json";
    const std::string of_first = read_whole_text(record);
    configure("[evaluate]\nhold_out = [\"IMG_0004.png\"]\n");
    ASSERT_EQ(build(), "uurrr");
    const std::string evaluate =
        "evaluate --mode perpixel --no-ghost-energy " + quoted(workspace());
    const auto expect_stale = [&] {
        const Outcome outcome = lumi(evaluate);
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_THAT(outcome.talk, HasSubstr("E-EVAL-STALE"));
    };
    const std::string of_second = read_whole_text(record);
    write_whole_text(record, of_first);  // As if the second run had ended before it was recorded.
    expect_stale();
    write_whole_text(record, of_second);
    EXPECT_EQ(lumi(evaluate).exit_code, 0);
    configure("max_width_px = 120\n[evaluate]\nhold_out = [\"IMG_0004.png\"]\n");
    ASSERT_EQ(build("ingest"), "r");
    expect_stale();
}

TEST_F(StaleEvaluation, WhatAFailedOrShorterRunLeftBehindIsNotMeasured) {
    const std::string evaluate =
        "evaluate --mode lightfield --no-ghost-energy " + quoted(workspace());
    const std::string held_out = "[evaluate]\nhold_out = [\"IMG_0005.png\"]\n";
    const auto expect_measured = [&] {
        const Outcome outcome = lumi(evaluate);
        EXPECT_EQ(outcome.exit_code, 0) << outcome.talk;
        EXPECT_THAT(read_whole_text(workspace() / "report.html"), HasSubstr("How close it comes"));
    };
    const auto expect_stale = [&] {
        const Outcome outcome = lumi(evaluate);
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_THAT(outcome.talk, HasSubstr("E-EVAL-STALE"));
        EXPECT_THAT(outcome.talk, HasSubstr("run `lumi build CONFIG.toml` again"));
        const std::string report = read_whole_text(workspace() / "report.html");
        EXPECT_THAT(report, Not(HasSubstr("How close it comes")));
        EXPECT_THAT(report, HasSubstr("is left out"));
    };
    configure(held_out);
    ASSERT_EQ(build(), "rrrrr");
    expect_measured();

    configure(held_out + "[package]\nmax_mib = 0.001\n");
    EXPECT_EQ(
        lumi("build " + quoted(config_path()) + " --workspace " + quoted(workspace())).exit_code,
        2);
    expect_stale();
    configure(held_out);
    EXPECT_EQ(build(), "uuuuu");
    expect_measured();

    configure("[evaluate]\nhold_out = [\"IMG_0004.png\"]\n");
    EXPECT_EQ(build("depth"), "uurr");
    expect_stale();
    configure(held_out);
    EXPECT_EQ(build("poses"), "uu");
    expect_stale();
    EXPECT_EQ(build(), "uurru");
    expect_measured();
    // What stands at its end needs no more than was asked for.
    EXPECT_EQ(build("poses"), "uu");
    expect_measured();
    configure(held_out + "[package]\nmax_views = 3\n");
    EXPECT_EQ(build("poses"), "uu");
    expect_stale();
}

}  // namespace
}  // namespace lumi
